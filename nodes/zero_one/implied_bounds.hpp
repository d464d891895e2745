// Bounds of columns implied by rows, which the safe bound requires for columns without bounds (such
// as a flow limited by a capacity row). Rounded outwards, so that no point is lost.
#pragma once

#include <span>
#include <vector>

#include "solvers/linear/linear_program.hpp"

namespace kusabi::zero_one {

struct ColumnBounds {
  std::vector<double> lower;
  std::vector<double> upper;

  friend bool operator==(const ColumnBounds&, const ColumnBounds&) = default;
};

/// The bounds of the columns themselves.
ColumnBounds own_bounds(const linear::LinearProgram& program);

/// Bounds that every point of the program with an objective of at most `cutoff` satisfies
/// (infinity: every point): those of the columns, tightened by all rows a few times.
ColumnBounds implied_bounds(const linear::LinearProgram& program, double cutoff = linear::infinity);

}  // namespace kusabi::zero_one
