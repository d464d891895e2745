// Reader of mixed zero-one programs in common formats: MPS, fixed or free (mps_file.hpp), and CPLEX
// LP, by GLPK; files named .gz are decompressed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include "solvers/linear/linear_program.hpp"

namespace kusabi::linear {

/// Content of a program file.
struct ProgramFile {
  MixedProgram mixed;     ///< to be minimised
  bool maximise = false;  ///< the costs of `mixed` are the negatives of those in the file
  /// `FILE:LINE: ...`: lines that other readers may interpret differently.
  std::vector<std::string> warnings = {};

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
/// omitted. An integer column must have bounds within 0 and 1, or be fixed.
/// @throws support::InputError `FILE:LINE: ...` for a fault in the file (for an LP file GLPK's
///   message); `FILE: ...` if it cannot be opened or decompressed, or a column of an LP file is a
///   general integer
ProgramFile read_program(const std::filesystem::path& file);

}  // namespace kusabi::linear
