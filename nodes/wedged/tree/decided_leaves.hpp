// Leaves that are decided alone, without a search of the tree.
#pragma once

#include <span>
#include <vector>

#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "solvers/conic/answer.hpp"
#include "support/stop.hpp"

namespace kusabi::wedged {

/// Configurations of those leaves that are feasible, in their order, decided in double precision.
/// After a stop request only those decided before. On one rank.
/// @param friction mu of each candidate
std::vector<Configuration> feasible_leaves(std::span<const PatternNode> leaves,
                                           const problems::WedgedProblem& problem,
                                           std::span<const double> friction,
                                           const conic::Tolerances& tolerances,
                                           const support::Stop& stop);

}  // namespace kusabi::wedged
