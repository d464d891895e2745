// Preparation of trees of sign patterns: the branching rule of each block, and bounds of its
// candidates if the tree is large enough.
#pragma once

#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/relaxation/candidate_bounds.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Trees of smaller blocks take less time than bounds of their candidates.
inline constexpr int min_candidates_to_bound = 24;
/// The same for unconstrained bodies, whose bounds cost more: a candidate opened by a rigid-body
/// mode has no bound of its gap.
inline constexpr int min_unconstrained_to_bound = 56;

/// Cost of bounding a candidate in nodes of the tree without cuts: about ten programs with up to
/// twice as many rows.
inline constexpr double nodes_per_candidate = 15;
/// Larger blocks are not bounded, since a sweep takes too long.
inline constexpr int max_candidates_to_bound = 200;

/// Branching rule and candidate bounds of one block.
struct Preparation {
  Branching branching = Branching::relative;
  RootBounds root;
};

/// Determines both for each block by the options. The work is distributed over the ranks; the
/// result does not depend on their number. Every rank makes the same call.
std::vector<Preparation> prepare(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                                 std::span<const double> friction,
                                 const SignPatternOptions& options);

/// Passes the rules and bounds to a tree of the same problem.
void configure(SignPatternTree& tree, std::span<const Preparation> blocks);

/// Removes all bounds: where the exact test refuses one, later ones may depend on it.
void remove_bounds(std::span<Preparation> blocks);

/// The bounds of all blocks, in the order of their proofs.
std::vector<ProvedBound> proved_bounds(std::span<const Preparation> blocks);

}  // namespace kusabi::wedged
