// One search for each block, until a pattern is feasible at the given friction and its leaf is
// decided.
#include "nodes/wedged/primal/primal_leaf.hpp"

#include <array>
#include <utility>

#include <boost/serialization/vector.hpp>

#include "nodes/wedged/critical/critical_start.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/primal/primal_search.hpp"
#include "nodes/wedged/tree/decided_leaves.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

std::optional<Configuration> leaf_without_tree(engine::Analysis& analysis,
                                               const problems::WedgedProblem& problem,
                                               std::span<const double> friction,
                                               const conic::Tolerances& tolerances) {
  const auto blocks = problems::blocks_of(problem);
  for (std::uint32_t number = 0; number < blocks.size(); ++number) {
    const int m = blocks[number].size();
    if (m < min_candidates_for_start) continue;
    auto block = problems::block_problem(problem, blocks[number]);
    block.friction.clear();
    for (const int i : blocks[number])
      block.friction.push_back(friction[static_cast<std::size_t>(i)]);
    const auto found = search_primal(analysis, block,
                                     {.infeasible = 0,
                                      .maximum = CriticalFriction::range(block).maximum,
                                      .enough = 1,
                                      .from = 1,
                                      .known = {}});
    if (!(found.best.factor <= 1)) continue;
    const std::array leaf{PatternNode{number, leaf_with(found.best.contact, m)}};
    auto leaves = analysis.by_first_rank([&] {
      return feasible_leaves(leaf, problem, friction, tolerances, analysis.budget().stop());
    });
    if (!leaves.empty()) return std::move(leaves.front());
  }
  return {};
}

}  // namespace kusabi::wedged
