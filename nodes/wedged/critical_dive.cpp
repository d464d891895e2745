// A stack of nodes, and the first leaf.
#include "nodes/wedged/critical_dive.hpp"

#include <cmath>
#include <utility>

#include "engine/together.hpp"
#include "nodes/wedged/candidate_friction.hpp"
#include "nodes/wedged/critical_friction.hpp"
#include "nodes/wedged/preparation.hpp"
#include "nodes/wedged/sign_pattern.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// A dive goes back and down again for so many nodes a candidate: then there may be nothing.
constexpr std::uint64_t dive_nodes_a_candidate = 100;

SignPatternTree tree_at(const problems::WedgedProblem& problem, double factor,
                        const BlockBounds& bounds) {
  SignPatternTree tree(problem, candidate_friction(problem, factor),
                       {.tolerances = CriticalFriction::tolerances});
  inform(tree, problem, bounds);
  return tree;
}

// From where on the leaf lives; infinity if that cannot be told.
double alive_from(const problems::WedgedProblem& problem, const Configuration& leaf,
                  std::int64_t multiple, double width) {
  const auto block = problems::blocks_of(problem)[leaf.block];
  CriticalFriction critical(problems::block_problem(problem, block), width);
  const auto cell = critical.locate(own_leaf(leaf, block), {.dead = 0, .alive = multiple},
                                    CriticalMethod::newton, multiple);
  if (cell.alive == CriticalCell::nowhere) return std::numeric_limits<double>::infinity();
  return critical.at(cell.alive);
}

}  // namespace

BlockBounds bounds_at(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                      double factor, Tightening tightening) {
  const auto blocks = problems::blocks_of(problem);
  BlockBounds result;
  result.blocks.resize(blocks.size());
  if (tightening == Tightening::never) return result;
  const int fewest = tightening == Tightening::always ? 1 : fewest_to_bound;
  const auto friction = candidate_friction(problem, factor);
  for (std::uint32_t block = 0; block < blocks.size(); ++block) {
    if (blocks[block].size() < fewest) continue;
    auto root = bound_candidates(campaign, problem, friction, block, CriticalFriction::tolerances);
    result.programs += root.programs;
    result.blocks[block] = std::move(root.bounds);
  }
  return result;
}

CriticalDive dive_at(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                     std::int64_t multiple, double width, const BlockBounds& bounds) {
  return campaign.by_first_rank([&] {
    auto tree = tree_at(problem, FrictionGrid(width).at(multiple), bounds);
    const auto most = dive_nodes_a_candidate * problem.contact_names.size();
    std::vector<SignPatternTree::Node> open{tree.root()};
    CriticalDive result;
    bool doubtful = false;
    while (!open.empty() && result.opened < most && !campaign.budget().spent()) {
      const auto node = open.back();
      open.pop_back();
      auto fate = tree.decide(node);
      ++result.opened;
      if (fate.leaf) {
        const bool lives =
            fate.leaf->state == LeafState::alive || fate.leaf->state == LeafState::flat;
        if (lives) result.alive = alive_from(problem, *fate.leaf, multiple, width);
        if (std::isfinite(result.alive)) return result;
        doubtful = true;
      }
      open.insert(open.end(), fate.children.rbegin(), fate.children.rend());
    }
    result.all_dead = open.empty() && !doubtful;
    return result;
  });
}

}  // namespace kusabi::wedged
