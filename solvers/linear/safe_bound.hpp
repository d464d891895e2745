// Safe bounds: rigorous lower bounds of a linear program: A. Neumaier, O. Shcherbina, Safe bounds
// in linear and mixed-integer programming, Math. Program. 99 (2004) 283-296.
//
// For any multipliers y of the rows and any point x of the program
//
//   c'x = y'(A x) + r'x >= sum_i min(y_i L_i, y_i U_i) + sum_j min(r_j l_j, r_j u_j),  r = c - A'y.
//
// The bound holds for any y and is best for optimal y. Every operation is rounded downwards.
#pragma once

#include <span>
#include <vector>

#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/rounded.hpp"

namespace kusabi::linear {

/// Lower bound of the objective over all points of the program. Multipliers on a missing bound of a
/// row count as zero. Minus infinity if a column with r_j > 0 has no lower bound, or one with r_j <
/// 0 no upper bound: all columns should have bounds.
/// @param duals one number per row
double safe_dual_bound(const LinearProgram& program, std::span<const double> duals);

/// With other bounds of the columns, those of a node.
double safe_dual_bound(const LinearProgram& program, std::span<const double> duals,
                       std::span<const double> lower, std::span<const double> upper);

/// The bound and its parts.
struct SafeBound {
  double value = -infinity;
  double finite_part = -infinity;   ///< without columns whose part is minus infinity
  std::vector<Interval> residuals;  ///< c - A'y, one per column
};
SafeBound safe_bound(const LinearProgram& program, std::span<const double> duals,
                     std::span<const double> lower, std::span<const double> upper);

/// Minimum of r x over r in `residual` and x in [lower, upper], rounded down: the contribution of
/// one column.
double min_product(const Interval& residual, double lower, double upper);

/// Maximum over r in `residual` of the minimum of r x over x in [lower, upper], rounded up: no more
/// than this is the contribution of the column to a bound.
/// @param lower, upper finite
double max_contribution(const Interval& residual, double lower, double upper);

/// The bound without costs: above zero if no point satisfies all rows and bounds.
double safe_infeasibility(const LinearProgram& program, std::span<const double> duals,
                          std::span<const double> lower, std::span<const double> upper);

}  // namespace kusabi::linear
