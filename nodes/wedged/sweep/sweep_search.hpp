// How the number of sign patterns grows with friction, exact between the points: the question that
// `kusabi sweep --mu` asks.
//
// One tree of sign patterns at the largest coefficient, and the history of each of its leaves. That
// is complete: what is closed as dead or as a face there is so at every smaller coefficient, and
// the solutions of a leaf at a smaller one are among those that it has at the largest.
#pragma once

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/sweep/sweep_findings.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

struct SweepQuestion {
  double most = 1;      ///< the largest coefficient
  double width = 1e-8;  ///< of the brackets
};

/// Every rank makes the same call; the findings are whole on rank 0, their status on all.
/// @throws std::invalid_argument if a coefficient or the width is out of range
SweepFindings sweep_friction(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                             const SweepQuestion& question);

}  // namespace kusabi::wedged
