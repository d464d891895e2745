// Choice of the branching rule of a block and estimate of its tree size by sampling the trees of
// all rules. On faces of meshes one rule may take a hundred times the nodes of another, and the
// best rule differs from face to face.
//
// A sample is a dive from the root: both children of each branched node are opened, and the dive
// continues with one of the branched children, with equal probability. The sum of nodes met, each
// times the number of choices above it, has the number of nodes of the tree as its expectation
// (Knuth, Estimating the efficiency of backtrack programs, 1975; opening both children removes the
// variance of long chains of infeasible nodes).
#pragma once

#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// The rule without sampling.
Branching untried_branching(int candidates);

/// A rule, and the number of nodes of its tree.
struct TriedTree {
  Branching branching = Branching::relative;
  double nodes = 0;  ///< an estimate; zero without sampling, infinity if only known not to be small
};

/// For each block the requested rule, or the result of sampling. The dives are distributed over the
/// ranks; the result does not depend on their number. Every rank makes the same call.
/// @param minimum smaller blocks are not sampled
std::vector<TriedTree> tried_trees(engine::Analysis& analysis,
                                   const problems::WedgedProblem& problem,
                                   std::span<const double> friction,
                                   const SignPatternOptions& options, int minimum);

}  // namespace kusabi::wedged
