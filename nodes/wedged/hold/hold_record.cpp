// Trees and leaves once more, with their evidence.
#include "nodes/wedged/hold/hold_record.hpp"

#include <algorithm>
#include <utility>

#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

LoadedPattern in_whole(const LoadedPattern& own, const support::IndexSet& candidates) {
  return {problems::in_whole(own.contact, candidates),
          problems::in_whole(own.separated, candidates)};
}

HoldOutcome on_all_ranks(engine::Analysis& analysis, const engine::OutcomeOf<HoldTree>& outcome) {
  return engine::from_first_rank(analysis.transport(), [&] {
    HoldOutcome result;
    result.status = outcome.status;
    for (const auto& each : outcome.solutions) result.leaf.push_back(each.solution);
    result.tally = outcome.tally();
    result.opened = outcome.opened();
    for (auto* const list : {&result.leaf, &result.tally.limits}) {
      std::ranges::sort(*list, {}, [](const auto& each) {
        return std::pair(each.pattern.contact, each.pattern.separated);
      });
    }
    return result;
  });
}

}  // namespace

HoldOutcome all_leaves(engine::Analysis& analysis, HoldTree& tree) {
  return on_all_ranks(analysis, analysis.search(tree, {}));
}

HoldOutcome first_leaf(engine::Analysis& analysis, HoldTree& tree) {
  engine::Options options;
  options.goal = engine::Goal::first;
  auto outcome = on_all_ranks(analysis, analysis.search(tree, options));
  if (!outcome.leaf.empty()) outcome.status = engine::Status::solved;
  return outcome;
}

void record_tree(engine::Analysis& analysis, const RecordedBlock& block,
                 std::span<const LoadShare> shares, const std::optional<GripRestriction>& grip,
                 HoldRecord& record) {
  HoldTree tree(block.problem, shares, block.mu, block.precision, grip);
  tree.report_to([&](const LoadedPattern& node, std::span<const double> numbers) {
    record.add(in_whole(node, block.candidates), numbers);
  });
  record.begin_tree(block.number, shares, grip);
  engine::Options options;
  options.goal = engine::Goal::first;
  record.end_tree(on_all_ranks(analysis, analysis.search_anew(tree, options)).is_infeasible());
}

void record_state(engine::Analysis& analysis, const RecordedBlock& block,
                  const LoadedPattern& pattern, const std::optional<LoadShare>& share,
                  const std::optional<GripRestriction>& grip, HoldRecord& record) {
  std::vector<LoadShare> shares;
  if (share) shares.push_back(*share);
  HoldNodes nodes(block.problem, shares, block.mu, block.precision, grip);
  nodes.end_when(analysis.budget().stop());
  if (nodes.sign(pattern) == HoldSign::feasible) {
    record.state(block.number, share, in_whole(pattern, block.candidates),
                 nodes.state_numbers(pattern));
  } else if (grip && grip->kind != GripRestriction::Kind::equal) {
    // The sum of the only state of its pattern is neither above nor below itself.
    record_state(analysis, block, pattern, share, {}, record);
  }
}

}  // namespace kusabi::wedged
