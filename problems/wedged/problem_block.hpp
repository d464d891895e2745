// One block of a wedged problem as a problem of its own.
#pragma once

#include <vector>

#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"

namespace kusabi::problems {

/// All candidates.
support::IndexSet all_candidates(const WedgedProblem& problem);

/// The blocks of the problem. One made by hand, which says nothing of blocks, is a single one.
std::vector<support::IndexSet> blocks_of(const WedgedProblem& problem);

/// The problem of some candidates alone, in their order: their names, frames, friction, K, F and
/// the motions of their bodies.
/// @param candidates a block, or all
WedgedProblem block_problem(const WedgedProblem& problem, const support::IndexSet& candidates);

/// The same of candidates that others are connected to, as if the others were none. Motions of
/// loose bodies that these do not see are left out.
WedgedProblem problem_without_others(const WedgedProblem& problem,
                                     const support::IndexSet& candidates);

/// A set of a block's own candidates (k for its k-th) as a set of the whole, and back.
support::IndexSet in_whole(const support::IndexSet& own, const support::IndexSet& block);
support::IndexSet in_block(const support::IndexSet& whole, const support::IndexSet& block);

}  // namespace kusabi::problems
