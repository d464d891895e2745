// Trees with the evidence of their nodes, and leaves once more.
#include "nodes/wedged/hold/hold_record.hpp"

#include <algorithm>
#include <utility>

#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

// The result with its leaves in one order. @param outcome of rank 0
HoldOutcome outcome_of(const engine::OutcomeOf<HoldTree>& outcome) {
  HoldOutcome result;
  result.status = outcome.status;
  for (const auto& each : outcome.solutions) result.leaves.push_back(each.solution);
  result.tally = outcome.tally();
  result.opened = outcome.opened();
  for (auto* const list : {&result.leaves, &result.tally.limits}) {
    std::ranges::sort(*list, {}, [](const auto& each) {
      return std::pair(each.pattern.contact, each.pattern.separated);
    });
  }
  return result;
}

HoldOutcome on_all_ranks(engine::Analysis& analysis, const engine::OutcomeOf<HoldTree>& outcome) {
  return engine::from_first_rank(analysis.transport(), [&] { return outcome_of(outcome); });
}

void report_nodes(HoldTree& tree, TreeEvidence& evidence) {
  evidence.nodes.emplace();
  tree.report_to([&nodes = *evidence.nodes, maximum = evidence.max_nodes](ClosedNode node) {
    if (!maximum || nodes.size() < *maximum) nodes.push_back(std::move(node));
  });
}

}  // namespace

LoadedPattern in_whole(const LoadedPattern& own, const support::IndexSet& candidates) {
  return {problems::in_whole(own.contact, candidates),
          problems::in_whole(own.separated, candidates)};
}

HoldTree tree_of(const LoadedProblem& block, const TreeEvidence& evidence, Precision precision) {
  HoldTree tree(block, evidence.shares, evidence.mu, precision, evidence.grip);
  if (evidence.except_dead) tree.except_dead();
  return tree;
}

HoldOutcome all_leaves(engine::Analysis& analysis, HoldTree& tree) {
  return on_all_ranks(analysis, analysis.search(tree, {}));
}

HoldOutcome first_leaf_of_small(engine::Analysis& analysis, HoldTree& tree, std::uint64_t maximum,
                                TreeEvidence* evidence) {
  // A journal may have the outcome of an earlier run, without its evidence.
  if (evidence != nullptr && !analysis.has_journal()) report_nodes(tree, *evidence);
  auto outcome = analysis.by_first_rank([&] {
    engine::Options options;
    options.goal = engine::Goal::first;
    options.limits.nodes = maximum;
    return outcome_of(analysis.search_alone(tree, options));
  });
  analysis.count_nodes(outcome.opened);
  if (evidence != nullptr) evidence->opened = outcome.opened;
  if (!outcome.leaves.empty()) outcome.status = engine::Status::solved;
  if (evidence != nullptr && outcome.status != engine::Status::solved) evidence->nodes.reset();
  return outcome;
}

HoldOutcome first_leaf(engine::Analysis& analysis, HoldTree& tree, TreeEvidence* evidence) {
  engine::Options options;
  options.goal = engine::Goal::first;
  // A search with a journal may begin where an earlier run ended, whose evidence is lost.
  if (evidence != nullptr && !analysis.has_journal()) report_nodes(tree, *evidence);
  auto outcome = on_all_ranks(analysis, analysis.search(tree, options));
  if (evidence != nullptr) evidence->opened = outcome.opened;
  if (!outcome.leaves.empty()) outcome.status = engine::Status::solved;
  return outcome;
}

void record_tree(engine::Analysis& analysis, const RecordedBlock& block, TreeEvidence evidence,
                 HoldRecord& record) {
  if (evidence.max_nodes && evidence.opened + evidence.bounds.size() > *evidence.max_nodes) return;
  if (!evidence.nodes) {
    HoldTree tree = tree_of(block.problem, evidence, block.precision);
    if (!evidence.bounds.empty()) {
      CandidateBounding bounding = tree.bounding();
      for (const auto& bound : evidence.bounds) bounding.add_bound(bound);
      tree.tighten(bounding.bounds());
    }
    report_nodes(tree, evidence);
    engine::Options options;
    options.goal = engine::Goal::first;
    if (evidence.max_nodes) options.limits.nodes = *evidence.max_nodes;
    if (!on_all_ranks(analysis, analysis.search_anew(tree, options)).is_infeasible()) return;
  }
  for (auto& node : *evidence.nodes) node.pattern = in_whole(node.pattern, block.candidates);
  const std::vector<int> numbers(block.candidates.begin(), block.candidates.end());
  for (auto& bound : evidence.bounds)
    bound.candidate = numbers[static_cast<std::size_t>(bound.candidate)];
  if (record.tree(block.number, evidence)) return;
  TreeEvidence without_bounds{evidence.mu, std::move(evidence.shares), evidence.grip,
                              evidence.except_dead};
  constexpr std::uint64_t larger = 100;  // a tree without bounds may be far larger
  without_bounds.max_nodes = evidence.max_nodes.value_or(larger * evidence.opened);
  record_tree(analysis, block, std::move(without_bounds), record);
}

void record_state(engine::Analysis& analysis, const RecordedBlock& block,
                  const LoadedPattern& pattern, const std::optional<LoadShare>& share,
                  const std::optional<GripRestriction>& grip, HoldRecord& record) {
  std::vector<LoadShare> shares;
  if (share) shares.push_back(*share);
  // Friction below the least coefficient of the solver counts as none: such a state is one with more
  // friction, too.
  LoadedProblem problem = block.problem;
  for (double& factor : problem.problem.friction)
    if (block.mu * factor < min_friction) factor = 0;
  HoldNodes nodes(problem, shares, block.mu, block.precision, grip);
  if (nodes.solve(pattern) == HoldResult::feasible) {
    record.state(block.number, share, in_whole(pattern, block.candidates),
                 nodes.state_numbers(pattern));
  } else if (grip && grip->kind != GripRestriction::Kind::equal) {
    // The sum of the only state of its pattern is neither above nor below itself.
    record_state(analysis, block, pattern, share, {}, record);
  }
}

}  // namespace kusabi::wedged
