// Which rule of branching the tree of a block is searched by, and how large that tree is, found out
// by sampling its trees by all of them. On faces of meshes one rule takes a hundred times the nodes
// of another, and which one that is differs from face to face.
//
// A sample is a dive from the root: of each branched node both children are opened, and the dive
// goes on from one of those that are branched in turn, with even odds. The nodes met, each times
// the number of ways there were to choose from above it, are on average as many as the tree has
// (Knuth, Estimating the efficiency of backtrack programs, 1975; that both children are opened
// takes the variance of long chains of dead ones out of it).
#pragma once

#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// What is best without a trial.
Branching untried_branching(int candidates);

/// A rule, and how many nodes its tree has.
struct TriedTree {
  Branching branching = Branching::relative;
  double nodes = 0;  ///< an estimate; zero if nobody looked, infinity if only that it is not small
};

/// For each block the rule that was asked for, or what the trial says. The ranks share the dives,
/// and come to the same, however many they are. Every rank makes the same call.
/// @param fewest smaller blocks are not looked at
std::vector<TriedTree> tried_trees(engine::Analysis& analysis,
                                   const problems::WedgedProblem& problem,
                                   std::span<const double> friction,
                                   const SignPatternOptions& options, int fewest);

}  // namespace kusabi::wedged
