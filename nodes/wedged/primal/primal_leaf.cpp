// A search of each block that ends with a pattern feasible at its friction, and that leaf decided.
#include "nodes/wedged/primal/primal_leaf.hpp"

#include <utility>

#include <boost/serialization/vector.hpp>

#include "nodes/wedged/critical/critical_start.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/primal/primal_search.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

// A list, since a single optional cannot be sent.
std::vector<Configuration> decided(engine::Analysis& analysis,
                                   const problems::WedgedProblem& problem,
                                   std::span<const double> friction,
                                   const conic::Tolerances& tolerances, const PatternNode& leaf) {
  return analysis.by_first_rank([&] {
    std::vector<Configuration> found;
    SignPatternTree tree(problem, friction,
                         {.tolerances = tolerances, .precision = Precision::doubles});
    tree.end_when(analysis.budget().stop());
    try {
      auto fate = tree.decide(leaf);
      if (fate.leaf && fate.leaf->state == LeafState::alive) found.push_back(std::move(*fate.leaf));
    } catch (const support::Stopped&) {
      found.clear();
    }
    return found;
  });
}

}  // namespace

std::optional<Configuration> leaf_without_tree(engine::Analysis& analysis,
                                               const problems::WedgedProblem& problem,
                                               std::span<const double> friction,
                                               const conic::Tolerances& tolerances) {
  const auto blocks = problems::blocks_of(problem);
  for (std::uint32_t number = 0; number < blocks.size(); ++number) {
    const int m = blocks[number].size();
    if (m < fewest_to_start) continue;
    auto block = problems::block_problem(problem, blocks[number]);
    block.friction.clear();
    for (const int i : blocks[number])
      block.friction.push_back(friction[static_cast<std::size_t>(i)]);
    const auto found = search_primal(analysis, block,
                                     {.infeasible = 0,
                                      .most = CriticalFriction::range(block).most,
                                      .enough = 1,
                                      .from = 1,
                                      .known = {}});
    if (!(found.best.factor <= 1)) continue;
    auto leaves = decided(analysis, problem, friction, tolerances,
                          {number, leaf_with(found.best.contact, m)});
    if (!leaves.empty()) return std::move(leaves.front());
  }
  return {};
}

}  // namespace kusabi::wedged
