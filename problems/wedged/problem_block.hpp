// One block of a wedged problem as a problem of its own.
#pragma once

#include <cstdint>
#include <vector>

#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::problems {

/// All candidates, bit i for candidate i.
std::uint64_t all_candidates(const WedgedProblem& problem);

/// The blocks of the problem. One made by hand, which says nothing of blocks, is a single one.
std::vector<std::uint64_t> blocks_of(const WedgedProblem& problem);

/// The problem of some candidates alone, in their order: their names, frames, friction, K and F.
/// @param candidates a block, or all
WedgedProblem block_problem(const WedgedProblem& problem, std::uint64_t candidates);

/// A set of a block's own candidates (bit k for its k-th) as a set of the whole, and back.
std::uint64_t in_whole(std::uint64_t own, std::uint64_t block);
std::uint64_t in_block(std::uint64_t whole, std::uint64_t block);

}  // namespace kusabi::problems
