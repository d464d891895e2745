// What is done before the trees of sign patterns are searched: the rule of branching of each block,
// and bounds of its candidates where the tree is large enough to pay for them.
#pragma once

#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/tree/candidate_bounds.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Smaller blocks have trees that are searched sooner than their candidates are bounded.
inline constexpr int fewest_to_bound = 24;
/// The same of loose bodies, whose bounds cost more: where a motion opens a candidate there is none
/// of its gap.
inline constexpr int fewest_of_loose_to_bound = 56;

/// Of one block.
struct Preparation {
  Branching branching = Branching::relative;
  RootBounds root;
};

/// Finds both for each block, as the options ask for. The ranks share the work, and come to the
/// same, however many they are. Every rank makes the same call.
std::vector<Preparation> prepare(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                                 std::span<const double> friction,
                                 const SignPatternOptions& options);

/// Lets a tree of the same problem know.
void inform(SignPatternTree& tree, std::span<const Preparation> blocks);

/// Those of all blocks, in the order in which they are proved.
std::vector<ProvedBound> proved_bounds(std::span<const Preparation> blocks);

}  // namespace kusabi::wedged
