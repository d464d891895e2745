// Rows and columns of an MPS file, and the program that they define (docs/mps.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/program_file.hpp"

namespace kusabi::linear {

/// A row of section ROWS, with its numbers of the other sections.
struct MpsRow {
  char type = 'N';
  std::string name;
  std::optional<double> right;
  std::optional<double> range;
  std::vector<LinearTerm> terms;
};

/// A column, with its bounds.
struct MpsColumn {
  std::string name;
  bool is_integer = false;
  double lower = 0;
  double upper = infinity;
  bool lower_given = false;
  bool upper_given = false;
  std::size_t line = 0;  ///< of its first entry
};

/// All sections of a file.
struct MpsContent {
  std::string name;
  bool maximise = false;
  std::optional<std::string> objective_name;  ///< of section OBJNAME
  std::vector<MpsRow> rows;
  std::vector<MpsColumn> columns;
  std::vector<std::string> warnings;
};

/// @throws support::InputError `FILE:LINE: fault; expected ...`
[[noreturn]] void refuse_line(const std::string& file, std::size_t line, std::string_view fault,
                              std::string_view expected);

/// The program of a file. @param file its name in messages  @param last_line its number of lines
/// @throws support::InputError if there is no objective, if the bounds of a column contradict each
///         other, or if an integer column has no bounds or is not binary
ProgramFile program_of(MpsContent content, const std::string& file, std::size_t last_line);

}  // namespace kusabi::linear
