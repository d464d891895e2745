// The tree at the largest coefficient, then the histories.
#include "nodes/wedged/sweep/sweep_search.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "engine/collectives.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "nodes/wedged/tree/preparation.hpp"
#include "nodes/wedged/tree/tree_leaves.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

// The leaves at the largest coefficient, including those contained in others, which may be maximal
// at a smaller one.
TreeLeaves leaves_at(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                     double maximum, SweepFindings& findings) {
  const auto friction = candidate_friction(problem, maximum);
  const SignPatternOptions options{.tolerances = resolving({}, rounding_of_files)};
  SignPatternTree tree(problem, friction, options);
  configure(tree, prepare(analysis, problem, friction, options));
  auto outcome = analysis.search(tree, {});
  auto leaves = tree_leaves(analysis, outcome);
  findings.tree_ranks = std::move(outcome.ranks);
  return leaves;
}

/// The first grid point at or above a coefficient.
std::int64_t not_below(double friction, const FrictionGrid& grid) {
  auto point = static_cast<std::int64_t>(std::llround(friction / grid.width()));
  while (grid.at(point) < friction) ++point;
  return point;
}

}  // namespace

SweepFindings sweep_friction(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                             const SweepParameters& parameters) {
  const auto& [maximum, width] = parameters;
  if (!(width > 0 && width < maximum) || maximum > max_multiples * width) {
    throw std::invalid_argument(
        "the width of a bracket is out of range; expected less than the largest friction "
        "coefficient, and no less than 1e-15 of it");
  }
  const FrictionGrid grid(width);
  const auto top = not_below(maximum, grid);
  SweepFindings findings;
  findings.maximum = maximum;
  auto at_most = leaves_at(analysis, problem, grid.at(top), findings);
  findings.status = at_most.status;
  if (findings.status != engine::Status::solved) return findings;
  const auto blocks = problems::blocks_of(problem);
  findings.enumerated = true;
  findings.blocks = blocks.size();
  std::vector<SweepTree::Leaf> leaves;
  for (const auto& leaf : at_most.leaves) leaves.push_back(SweepTree::leaf_of(leaf, blocks));
  SweepTree tree(problem, width, top, std::move(leaves));
  auto outcome = analysis.search(tree, {});
  findings.status = engine::from_first_rank(analysis.transport(), [&] { return outcome.status; });
  findings.history_ranks = std::move(outcome.ranks);
  if (!analysis.is_first()) return findings;
  std::vector<SweptLeaf> histories;
  for (auto& leaf : at_most.leaves)
    histories.push_back({leaf.block, std::move(leaf.pattern), std::nullopt});
  for (auto& found : outcome.solutions)
    histories[found.solution.number].history = std::move(found.solution.history);
  add_histories(findings, histories, blocks, grid);
  return findings;
}

}  // namespace kusabi::wedged
