// Mixed zero-one programs from files that every solver of such programs reads: MPS, fixed or free
// (mps_file.hpp), and CPLEX LP, which GLPK reads; with a name that ends in .gz they are unpacked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include "solvers/linear/linear_program.hpp"

namespace kusabi::linear {

/// A program as it is in a file.
struct ProgramFile {
  MixedProgram mixed;     ///< to be minimised
  bool maximise = false;  ///< the costs of `mixed` are the negatives of the file's
  std::vector<std::string> warnings =
      {};  ///< `FILE:LINE: ...`: what other readers may take otherwise

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    auto& [name, constant, columns, rows, entries] = mixed.program;
    archive& maximise& mixed.binaries& name& constant& warnings;
    serialize_list(archive, columns, [&](auto& column) {
      archive& column.cost& column.lower& column.upper& column.name;
    });
    serialize_list(archive, rows, [&](auto& row) { archive& row.lower& row.upper& row.name; });
    serialize_list(archive, entries,
                   [&](auto& entry) { archive& entry.row& entry.column& entry.value; });
  }

 private:
  template <class Archive, class List, class Each>
  static void serialize_list(Archive& archive, List& list, const Each& each) {
    std::uint64_t size = list.size();
    archive& size;
    list.resize(size);
    for (auto& element : list) each(element);
  }
};

/// Reads a file whose name ends in .mps or .lp (or one of these and .gz). Rows without bounds are
/// left out. An integer column must fit between 0 and 1, or be fixed.
/// @throws support::InputError `FILE:LINE: ...` where the file is wrong (of an LP file in GLPK's
///   words); `FILE: ...` if it cannot be opened or unpacked, or a column of an LP file is a general
///   integer
ProgramFile read_program(const std::filesystem::path& file);

}  // namespace kusabi::linear
