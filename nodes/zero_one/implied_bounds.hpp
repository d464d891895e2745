// Bounds of columns that follow from the rows: what the safe bound needs of columns that were given
// none (a flow that only its capacity row holds). Rounded outwards, so that no point is lost.
#pragma once

#include <span>
#include <vector>

#include "solvers/linear/linear_program.hpp"

namespace kusabi::zero_one {

struct ColumnBounds {
  std::vector<double> lower;
  std::vector<double> upper;
};

/// The bounds of the columns themselves.
ColumnBounds own_bounds(const linear::LinearProgram& program);

/// Bounds that every point of the program with an objective of at most `cutoff` satisfies
/// (infinity: every point at all): those of the columns, made tighter by one row after another a
/// few times.
ColumnBounds implied_bounds(const linear::LinearProgram& program, double cutoff = linear::infinity);

}  // namespace kusabi::zero_one
