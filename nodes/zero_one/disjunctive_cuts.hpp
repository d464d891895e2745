// Disjunctive cut: step 2 of Algorithm 5.1 of the limit paper (cut_rounds.hpp), for any mixed
// zero-one program.
//
// For a fractional binary tau_j the cut-generating program (51) finds, among the inequalities
// alpha'x >= beta that hold on both sides of tau_j = 0 or tau_j = 1, the one with the largest
// violation at the optimum of the relaxation, with |alpha_i| <= 1. As in section 5.2, columns at a
// bound are left out of it and their alpha_i completed afterwards, by (53) to (59). One correction:
// for z_i = 0 the paper requires xi+ = eta-, xi- = eta+ besides (53), which loses depth (each side
// may have its own difference xi+ - xi-); here both differences are free, which is all that (53)
// implies.
//
// beta is computed anew from alpha and both sides' multipliers, by the safe bound where there is
// one: rounding then cannot make a cut invalid.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "nodes/zero_one/relaxation.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::zero_one {

/// alpha'x >= beta
struct DisjunctiveCut {
  std::vector<linear::LinearTerm> terms;
  double lower = 0;
  double violation = 0;  ///< at its point, with max |alpha_i| between 1/2 and 1
};

/// The deepest cut for one binary by (51), from the first `rows` rows of the relaxation; none if
/// the point satisfies all inequalities of both sides.
/// @param point values of all columns
std::optional<DisjunctiveCut> deepest_cut(const Relaxation& relaxation, std::size_t rows,
                                          const std::vector<double>& point, std::size_t binary);

}  // namespace kusabi::zero_one
