// The first way down: whether something lives at a coefficient of friction, by going into the tree
// of sign patterns depth first until a leaf lives, and from which coefficient on that one does. A
// descent that begins far above the smallest coefficient comes near it by a few of these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/tree/branching_trial.hpp"
#include "nodes/wedged/tree/candidate_bounds.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/wedged/problem_block.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Of the candidates of each block at some coefficient, and so at all smaller ones: cones grow with
/// friction. Empty for blocks that have none.
struct BlockBounds {
  std::vector<std::vector<CandidateBounds>> blocks;
  std::uint64_t programs = 0;
};

/// Bounds the candidates of the blocks, unless told otherwise of the large ones of held bodies.
/// Every rank makes the same call. @param factor of the candidates' own coefficients
BlockBounds bounds_at(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                      double factor, Tightening tightening);

/// Lets a tree at that coefficient, or at a smaller one, know: how its blocks are split, too.
template <class Tree>
void inform(Tree& tree, const problems::WedgedProblem& problem, const BlockBounds& bounds) {
  const auto blocks = problems::blocks_of(problem);
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    const bool bounded = block < bounds.blocks.size() && !bounds.blocks[block].empty();
    tree.split_by(block, bounded ? Branching::weighed : untried_branching(blocks[block].size()));
    if (bounded) tree.tighten(block, bounds.blocks[block]);
  }
}

/// What a dive came upon.
struct CriticalDive {
  /// A leaf lives from here on, a multiple of the width; infinity: none was come upon.
  double alive = std::numeric_limits<double>::infinity();
  PatternNode leaf;          ///< it
  bool all_dead = false;     ///< the whole tree was searched, and nothing in it is left
  std::uint64_t opened = 0;  ///< nodes, programs as well

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& alive& leaf& all_dead& opened;
  }
};

/// Dives at a multiple of the width, on the first rank, for so many nodes as it may need; every
/// rank makes the same call and gets the same.
CriticalDive dive_at(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                     std::int64_t multiple, const CriticalGrid& grid, const BlockBounds& bounds);

}  // namespace kusabi::wedged
