// Depth-first search for one feasible leaf at a coefficient of friction, and the critical
// coefficient of that leaf. A few dives bring a descent from a large coefficient close to the
// smallest one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/relaxation/candidate_bounds.hpp"
#include "nodes/wedged/tree/branching_trial.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/wedged/problem_block.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Bounds of the candidates of each block at some coefficient. They hold at all smaller
/// coefficients, since friction cones grow with the coefficient. Empty for blocks without bounds.
struct BlockBounds {
  std::vector<std::vector<CandidateBounds>> blocks;
  std::uint64_t programs = 0;
};

/// Bounds the candidates of the blocks; by default large blocks of constrained bodies are skipped.
/// Every rank makes the same call. @param factor of the candidates' own coefficients
BlockBounds bounds_at(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                      double factor, Tightening tightening);

/// Passes the bounds and branching rules to a tree at that coefficient or a smaller one.
template <class Tree>
void configure(Tree& tree, const problems::WedgedProblem& problem, const BlockBounds& bounds) {
  const auto blocks = problems::blocks_of(problem);
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    const bool bounded = block < bounds.blocks.size() && !bounds.blocks[block].empty();
    tree.split_by(block, bounded ? Branching::weighed : untried_branching(blocks[block].size()));
    if (bounded) tree.tighten(block, bounds.blocks[block]);
  }
}

/// Result of a dive.
struct CriticalDive {
  /// Multiple of the width from which on the leaf is feasible; infinity: no leaf was found.
  double feasible = std::numeric_limits<double>::infinity();
  PatternNode leaf;             ///< the feasible leaf
  bool all_infeasible = false;  ///< the whole tree was searched and is infeasible
  std::uint64_t opened = 0;     ///< nodes, which are also programs

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& feasible& leaf& all_infeasible& opened;
  }
};

/// Dives at a multiple of the width, on the first rank, within a limit of nodes. Every rank makes
/// the same call and gets the same result.
CriticalDive dive_at(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                     std::int64_t multiple, const CriticalGrid& grid, const BlockBounds& bounds);

}  // namespace kusabi::wedged
