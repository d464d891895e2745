// Depth-first search with a stack of nodes until the first feasible leaf.
#include "nodes/wedged/critical/critical_dive.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/collectives.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "nodes/wedged/tree/preparation.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// Maximum number of nodes of a dive for each candidate, including backtracking; there may be no
/// feasible leaf.
constexpr std::uint64_t dive_nodes_per_candidate = 100;

/// Larger blocks are not bounded, since the programs take longer than the dives.
constexpr int max_candidates_to_bound_in_dives = 100;

SignPatternTree tree_at(const problems::WedgedProblem& problem, double factor,
                        const CriticalGrid& grid, const BlockBounds& bounds) {
  SignPatternTree tree(problem, candidate_friction(problem, factor),
                       {.tolerances = CriticalFriction::tolerances, .precision = grid.precision});
  configure(tree, problem, bounds);
  return tree;
}

// Finds the coefficient from which on the leaf is feasible; infinity if numerically undecided.
void locate(const problems::WedgedProblem& problem, const Configuration& found,
            std::int64_t multiple, const CriticalGrid& grid, const support::Stop& stop,
            CriticalDive& dive) {
  const auto block = problems::blocks_of(problem)[found.block];
  CriticalFriction critical(problems::block_problem(problem, block), grid.width, grid.precision);
  critical.end_when(stop);
  const PatternNode leaf{found.block, own_leaf(found, block)};
  const auto cell = critical.locate(leaf.pattern, {.infeasible = 0, .feasible = multiple},
                                    CriticalMethod::newton, multiple);
  if (cell.feasible == CriticalCell::nowhere) return;
  dive.feasible = critical.at(cell.feasible);
  dive.leaf = leaf;
}

// Ends at a feasible leaf, when all nodes are infeasible, or with a partial result when the run is
// to stop.
void dive(engine::Analysis& analysis, const problems::WedgedProblem& problem, std::int64_t multiple,
          const CriticalGrid& grid, const BlockBounds& bounds, CriticalDive& result) {
  const auto stop = analysis.budget().stop();
  auto tree = tree_at(problem, FrictionGrid(grid.width).at(multiple), grid, bounds);
  tree.end_when(stop);
  const auto maximum = std::min<std::uint64_t>(
      dive_nodes_per_candidate * problem.contact_names.size(), analysis.budget().left().nodes);
  std::vector<SignPatternTree::Node> open{tree.root()};
  bool undecided = false;
  try {
    while (!open.empty() && result.opened < maximum && !support::is_requested(stop)) {
      const auto node = open.back();
      open.pop_back();
      auto decision = tree.decide(node);
      ++result.opened;
      analysis.say_now_and_then([&] {
        return fmt::format("looking for a pattern at friction coefficient {:.6g}: {} nodes",
                           FrictionGrid(grid.width).at(multiple), result.opened);
      });
      if (decision.leaf) {
        if (decision.leaf->is_cone()) locate(problem, *decision.leaf, multiple, grid, stop, result);
        if (std::isfinite(result.feasible)) return;
        undecided = true;
      }
      open.insert(open.end(), decision.children.rbegin(), decision.children.rend());
    }
  } catch (const support::Stopped&) {
    return;
  }
  result.all_infeasible = open.empty() && !undecided;
}

}  // namespace

BlockBounds bounds_at(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                      double factor, Tightening tightening) {
  const auto blocks = problems::blocks_of(problem);
  BlockBounds result;
  result.blocks.resize(blocks.size());
  if (tightening == Tightening::never) return result;
  const int min_candidates = tightening == Tightening::always ? 1 : min_candidates_to_bound;
  const auto friction = candidate_friction(problem, factor);
  for (std::uint32_t block = 0; block < blocks.size(); ++block) {
    if (blocks[block].size() < min_candidates) continue;
    if (tightening == Tightening::automatic &&
        blocks[block].size() > max_candidates_to_bound_in_dives)
      continue;
    auto root = bound_candidates(analysis, problem, friction, block, CriticalFriction::tolerances);
    result.programs += root.programs;
    result.blocks[block] = std::move(root.bounds);
  }
  return result;
}

CriticalDive dive_at(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                     std::int64_t multiple, const CriticalGrid& grid, const BlockBounds& bounds) {
  const auto result = analysis.by_first_rank([&] {
    CriticalDive own;
    dive(analysis, problem, multiple, grid, bounds, own);
    return own;
  });
  analysis.count_nodes(result.opened);
  return result;
}

}  // namespace kusabi::wedged
