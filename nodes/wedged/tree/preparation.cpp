// Decision on candidate bounds by the size of the tree without them.
#include "nodes/wedged/tree/preparation.hpp"

#include <limits>

#include "nodes/wedged/tree/branching_trial.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

bool pays(const TriedTree& tree, int candidates, Tightening tightening) {
  if (tightening == Tightening::never) return false;
  if (tightening == Tightening::always) return true;
  return candidates <= max_candidates_to_bound && tree.nodes > nodes_per_candidate * candidates;
}

}  // namespace

std::vector<Preparation> prepare(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                                 std::span<const double> friction,
                                 const SignPatternOptions& options) {
  const bool is_unconstrained = problem.modes.matrix.cols() > 0;
  // The tree size is not estimated if an option decides on candidate bounds.
  const int minimum = options.tightening != Tightening::automatic ? std::numeric_limits<int>::max()
                      : is_unconstrained                          ? min_unconstrained_to_bound
                                                                  : min_candidates_to_bound;
  const auto trees = tried_trees(analysis, problem, friction, options, minimum);
  const auto blocks = problems::blocks_of(problem);
  std::vector<Preparation> result(blocks.size());
  for (std::uint32_t block = 0; block < blocks.size(); ++block) {
    auto& own = result[block];
    own.branching = trees[block].branching;
    const int candidates = blocks[block].size();
    if (options.facets != 0 || !pays(trees[block], candidates, options.tightening)) continue;
    own.root = bound_candidates(analysis, problem, friction, block, options.tolerances);
    // With cuts the centre is a better criterion than the first point that proves a node feasible.
    if (options.branching == Branching::automatic && own.branching == Branching::relative &&
        !is_unconstrained)
      own.branching = Branching::weighed;
  }
  return result;
}

void configure(SignPatternTree& tree, std::span<const Preparation> blocks) {
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    tree.split_by(block, blocks[block].branching);
    if (!blocks[block].root.bounds.empty()) tree.tighten(block, blocks[block].root.bounds);
  }
}

void remove_bounds(std::span<Preparation> blocks) {
  for (auto& block : blocks) {
    block.root.bounds.clear();
    block.root.proved.clear();
  }
}

std::vector<ProvedBound> proved_bounds(std::span<const Preparation> blocks) {
  std::vector<ProvedBound> all;
  for (const auto& block : blocks)
    all.insert(all.end(), block.root.proved.begin(), block.root.proved.end());
  return all;
}

}  // namespace kusabi::wedged
