// Number of sign patterns as a function of friction, also between the grid points: the analysis of
// `kusabi sweep --mu`.
//
// It takes one tree of sign patterns at the largest coefficient, and the history of each of its
// leaves. This is complete: a node closed as infeasible or as a face there is so at every smaller
// coefficient, and the solutions of a leaf at a smaller one are solutions at the largest.
#pragma once

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/sweep/sweep_findings.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

struct SweepParameters {
  double maximum = 1;   ///< the largest coefficient
  double width = 1e-8;  ///< of the brackets
};

/// Every rank makes the same call; the findings are complete on rank 0, their status on all.
/// @throws std::invalid_argument if a coefficient or the width is out of range
SweepFindings sweep_friction(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                             const SweepParameters& parameters);

}  // namespace kusabi::wedged
