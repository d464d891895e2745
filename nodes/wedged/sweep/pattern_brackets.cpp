// Conversion of leaves to patterns of the bisection, and of cells to numbers.
#include "nodes/wedged/sweep/pattern_brackets.hpp"

#include <cstddef>
#include <utility>

#include <boost/serialization/vector.hpp>

#include "engine/collectives.hpp"
#include "nodes/wedged/sweep/sweep_tree.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// Cells from zero to the coefficient at which patterns are known.
constexpr std::int64_t cells_to_known = 100'000'000;

CriticalPatternTree::Pattern pattern_of(const Configuration& leaf,
                                        const std::vector<support::IndexSet>& blocks) {
  return {.leaf = own_node(leaf, blocks),
          .feasible = leaf.state == LeafState::feasible || leaf.state == LeafState::flat};
}

}  // namespace

engine::Outcome<CriticalPatternTree> bracket_patterns(engine::Analysis& analysis,
                                                      const problems::WedgedProblem& problem,
                                                      const std::vector<Configuration>& leaves,
                                                      CriticalMethod method, double width,
                                                      std::int64_t start) {
  const auto blocks = problems::blocks_of(problem);
  std::vector<CriticalPatternTree::Pattern> patterns;
  patterns.reserve(leaves.size());
  for (const auto& leaf : leaves) patterns.push_back(pattern_of(leaf, blocks));
  const auto count = static_cast<std::int64_t>(patterns.size());
  const auto sections = count == 0 ? 1 : analysis.transport().size() / count;
  CriticalPatternTree tree(problem, width, patterns, start, method, sections);
  return analysis.search(tree, {});
}

std::vector<PatternBracket> pattern_brackets(engine::Analysis& analysis,
                                             const problems::WedgedProblem& problem,
                                             const std::vector<Configuration>& leaves,
                                             double coefficient) {
  const auto known = engine::from_first_rank(analysis.transport(), [&] { return leaves; });
  if (known.empty()) return {};
  const double width = coefficient / static_cast<double>(cells_to_known);
  const auto blocks = problems::blocks_of(problem);
  std::vector<SweepTree::Leaf> own;
  for (const auto& leaf : known) own.push_back(SweepTree::leaf_of(leaf, blocks));
  SweepTree tree(problem, width, cells_to_known, own);
  const auto outcome = analysis.search(tree, {});
  if (!analysis.is_first() || outcome.status != engine::Status::solved) return {};
  const FrictionGrid grid(width);
  std::vector<PatternBracket> brackets(known.size());
  for (const auto& found : outcome.solutions) {
    const auto& [number, history] = found.solution;
    auto& bracket = brackets[number];
    if (const auto* const change = history.change_to(own[number].stage)) {
      bracket = {grid.at(change->before), grid.at(change->after)};
    } else if (history.open_above != LeafHistory::never) {
      bracket.lower = grid.at(history.open_above);
    }
  }
  return brackets;
}

}  // namespace kusabi::wedged
