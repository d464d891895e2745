// One wedged configuration at given friction by the primal heuristic: an answer to --exists without
// a tree.
#pragma once

#include <optional>
#include <span>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// A feasible leaf of one of the blocks that are not small; nothing if none was found. Every rank
/// makes the same call and gets the same result. @param friction mu of each candidate
std::optional<Configuration> leaf_without_tree(engine::Analysis& analysis,
                                               const problems::WedgedProblem& problem,
                                               std::span<const double> friction,
                                               const conic::Tolerances& tolerances);

}  // namespace kusabi::wedged
