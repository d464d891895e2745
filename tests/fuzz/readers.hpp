// Inputs of a fuzzer for the readers of the command: any bytes must be read, or refused in one
// line. The same harness serves libFuzzer (fuzz_readers.cpp) and the quick test of every build
// (readers_test.cpp).
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace kusabi::fuzz {

/// The kinds of file that the command reads.
enum class Reader {
  structure,    ///< a problem file (TOML)
  gmsh,         ///< a mesh of Gmsh, in the plane and in space
  abaqus,       ///< a mesh of Abaqus or CalculiX, likewise; it may include itself
  matrix,       ///< a stiffness: Matrix Market, a substructure of CalculiX, or its stored matrix
  mps,          ///< a mixed zero-one program
  lp,           ///< the same in CPLEX LP format
  certificate,  ///< of patterns, or of a worst-case limit load, whichever its first line says
  checkpoint,   ///< a manifest (the first line) and its first part (the rest)
};

inline constexpr std::array readers{Reader::structure,   Reader::gmsh,      Reader::abaqus,
                                    Reader::matrix,      Reader::mps,       Reader::lp,
                                    Reader::certificate, Reader::checkpoint};

/// The name of its folder in tests/fuzz/corpus, and of its value of KUSABI_FUZZ_READER.
std::string name_of(Reader reader);

/// @return nothing if no reader has that name
std::optional<Reader> reader_named(std::string_view name);

/// Violation of the rules that all readers satisfy.
class Defect : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Gives the bytes to the reader, and accepted input to the next step of the command.
/// @return the line with which they are refused, or nothing
/// @throws Defect if an error is not of the reader's own type, its message is not one line, or the
///   accepted input violates the reader's contract
std::optional<std::string> try_reader(Reader reader, const std::string& bytes);

/// Recomputes checksums and digests, so that they do not detect a change.
void repair(Reader reader, std::string& bytes);

}  // namespace kusabi::fuzz
