// Division of ranges of leaves.
#include "nodes/wedged/sweep/sweep_tree.hpp"

#include <utility>

#include "engine/search.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

SweepTree::Leaf SweepTree::leaf_of(const Configuration& found,
                                   const std::vector<support::IndexSet>& blocks) {
  Leaf leaf{.place = own_node(found, blocks), .stage = {LeafStage::Kind::unresolved, {}, {}}};
  if (found.state == LeafState::feasible) leaf.stage.kind = LeafStage::Kind::solid;
  if (found.state == LeafState::flat)
    leaf.stage = {LeafStage::Kind::flat, leaf.place.pattern.contact,
                  problems::in_block(found.pattern.separated, blocks[found.block])};
  return leaf;
}

SweepTree::SweepTree(const problems::WedgedProblem& problem, double width, std::int64_t maximum,
                     std::vector<Leaf> leaves)
    : leaves_(std::move(leaves)), maximum_(maximum) {
  for (const auto& candidates : problems::blocks_of(problem)) {
    critical_.emplace_back(problems::block_problem(problem, candidates), width);
    critical_.back().end_when(interruption_.stop());
  }
}

SweepTree::Tally SweepTree::tally() const {
  Tally tally = tally_;
  for (const auto& block : critical_) tally.programs += block.programs();
  return tally;
}

SweepTree::Node SweepTree::root() const {
  return {.first = 0, .last = leaves_.size()};
}

void SweepTree::expand(Node&& node, engine::Expansion<SweepTree>& out) {
  if (node.size() == 0 || branch_into_halves(node, 1, out)) return;
  const Leaf& leaf = leaves_[node.first];
  auto history = interruption_.within(out, node, [&] {
    return leaf_history(critical_[leaf.place.block], leaf.place.pattern, leaf.stage, maximum_);
  });
  if (!history) return;
  ++tally_.leaves;
  out.solution({static_cast<std::uint32_t>(node.first), *std::move(history)});
}

}  // namespace kusabi::wedged

template kusabi::engine::OutcomeOf<kusabi::wedged::SweepTree> kusabi::engine::search(
    kusabi::wedged::SweepTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
