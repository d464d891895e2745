// LinearProgram and MixedProgram: a linear program and a mixed zero-one program as plain data,
// assembled by the mechanics and solved by solvers/linear and nodes/zero_one. The form is that of
// the limit paper's (29) and of all solvers: rows and columns with two-sided bounds.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kusabi::linear {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A term of a row: value * x[column].
struct LinearTerm {
  int column = 0;
  double value = 0;
};

/// An entry of the matrix. Each position (row, column) occurs at most once.
struct LinearEntry {
  int row = 0;
  int column = 0;
  double value = 0;
};

struct LinearColumn {
  double cost = 0;
  double lower = 0;         ///< minus infinity: unbounded
  double upper = infinity;  ///< infinity: unbounded
  std::string name = {};    ///< may be empty
};

struct LinearRow {
  double lower = -infinity;
  double upper = infinity;
  std::string name = {};
};

/// Minimise constant + c'x with lower <= a'x <= upper for every row and lower <= x <= upper for
/// every column. Indices count from 0, in the order of addition.
struct LinearProgram {
  std::string name = {};
  double constant = 0;
  std::vector<LinearColumn> columns = {};
  std::vector<LinearRow> rows = {};
  std::vector<LinearEntry> entries = {};

  /// @return its index
  int add_column(LinearColumn column) {
    columns.push_back(std::move(column));
    return static_cast<int>(columns.size()) - 1;
  }

  /// Omits terms that are zero. @return its index
  int add_row(LinearRow row, std::span<const LinearTerm> terms) {
    const int index = static_cast<int>(rows.size());
    rows.push_back(std::move(row));
    for (const auto& [column, value] : terms) {
      if (value != 0) entries.push_back({index, column, value});
    }
    return index;
  }
};

/// A linear program with columns that must be 0 or 1; their bounds lie within [0, 1].
struct MixedProgram {
  LinearProgram program;
  std::vector<int> binaries;  ///< columns, each once
};

}  // namespace kusabi::linear
