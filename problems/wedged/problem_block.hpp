// Wedged problem of a single block.
#pragma once

#include <vector>

#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"

namespace kusabi::problems {

/// All candidates.
support::IndexSet all_candidates(const WedgedProblem& problem);

/// The blocks of the problem; a single one if it does not specify any.
std::vector<support::IndexSet> blocks_of(const WedgedProblem& problem);

/// The problem of some candidates, in their order: their names, frames, friction, K, F and
/// rigid-body modes.
/// @param candidates a block, or all
WedgedProblem block_problem(const WedgedProblem& problem, const support::IndexSet& candidates);

/// The same for a part of a block, as if the other candidates did not exist. Rigid-body modes of
/// unconstrained bodies that do not displace the given candidates are left out.
WedgedProblem problem_without_others(const WedgedProblem& problem,
                                     const support::IndexSet& candidates);

/// Conversion of candidates of a block (k for its k-th) to those of the whole, and back.
support::IndexSet in_whole(const support::IndexSet& own, const support::IndexSet& block);
support::IndexSet in_block(const support::IndexSet& whole, const support::IndexSet& block);

}  // namespace kusabi::problems
