// The leaves sorted into blocks and counted.
#include "nodes/wedged/pattern_search.hpp"

#include <algorithm>
#include <utility>

#include "nodes/wedged/preparation.hpp"
#include "nodes/wedged/simple_leaves.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

// Those that a search that stopped early did not come upon, up to so many in all.
void add_missing(std::vector<Configuration>& known, std::uint64_t most,
                 std::vector<Configuration>& leaves) {
  for (auto& leaf : known) {
    const bool found = std::ranges::any_of(leaves, [&](const auto& other) {
      return other.block == leaf.block && other.pattern == leaf.pattern;
    });
    if (!found && leaves.size() < most) leaves.push_back(std::move(leaf));
  }
}

}  // namespace

PatternFindings find_patterns(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                              std::span<const double> friction, const PatternQuestion& question) {
  SignPatternTree tree(problem, friction, question.tree);
  std::vector<Configuration> known;
  if (question.tree.facets == 0)
    known = simple_leaves(campaign, problem, friction, question.tree.tolerances);
  // Without a search where these are all that is asked for.
  const bool enough = known.size() >= campaign.budget().left().solutions;
  auto search = question.search;
  if (enough) search.limits.nodes = 0;
  const SignPatternOptions as_it_is{.tolerances = question.tree.tolerances,
                                    .branching = Branching::relative,
                                    .tightening = Tightening::never};
  const auto prepared = prepare(campaign, problem, friction, enough ? as_it_is : question.tree);
  inform(tree, prepared);
  if (question.witness) tree.report_to(question.witness);
  PatternFindings findings;
  findings.outcome = campaign.search(tree, search);
  if (enough) findings.outcome.status = engine::Status::solution_limit;
  std::vector<Configuration> leaves;
  for (const auto& found : findings.outcome.solutions) leaves.push_back(found.solution);
  if (!findings.whole()) add_missing(known, campaign.budget().left().solutions, leaves);
  findings.leaves = maximal_cones(std::move(leaves));
  findings.tested = findings.outcome.tally().tested;
  std::ranges::sort(findings.tested, [](const auto& a, const auto& b) {
    return a.block != b.block ? a.block < b.block : comes_before(a.pattern, b.pattern);
  });
  findings.bounds = proved_bounds(prepared);
  for (const auto& candidates : problems::blocks_of(problem)) {
    const auto& own = prepared[findings.blocks.size()];
    findings.blocks.push_back({.candidates = candidates,
                               .branching = own.branching,
                               .bound_programs = own.root.programs,
                               .cones = 0,
                               .open = 0});
  }
  for (const auto& leaf : findings.leaves) {
    auto& block = findings.blocks[leaf.block];
    switch (leaf.state) {
      case LeafState::flat:
        ++findings.flat;
        [[fallthrough]];
      case LeafState::alive:
        ++block.cones;
        break;
      case LeafState::marginal:
        ++findings.marginal;
        ++block.open;
        break;
      case LeafState::undecided:
        ++findings.undecided;
        ++block.open;
        break;
    }
  }
  return findings;
}

support::ExactCount PatternFindings::count() const {
  std::vector<std::uint64_t> cones;
  for (const auto& block : blocks) cones.push_back(block.cones);
  return combinations(cones);
}

support::IndexSet PatternFindings::idle() const {
  support::IndexSet candidates;
  if (!whole()) return candidates;
  for (const auto& block : blocks) {
    if (block.rests()) candidates |= block.candidates;
  }
  return candidates;
}

}  // namespace kusabi::wedged
