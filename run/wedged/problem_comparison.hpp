// Comparison of the problem on all ranks. Each rank prepares the problem from the same text; before
// the search they compare the results bit by bit, since another machine or build may round
// differently, and its part of the tree would belong to another problem.
#pragma once

#include "problems/wedged/wedged_problem.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// @throws engine::RankMismatch on every rank unless stiffness, compliance and all other parts of
/// the problem are the same on all of them
void require_equal_on_all_ranks(Session& session, const problems::WedgedProblem& problem);

}  // namespace kusabi::run
