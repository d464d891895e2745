// Criteria for dividing a list and for discarding a part.
#include "nodes/wedged/rays/ray_list_tree.hpp"

#include <algorithm>
#include <utility>

#include "engine/search.hpp"
#include "support/stop.hpp"

namespace kusabi::wedged {

std::uint64_t memory_of_lists(int candidates, std::uint64_t longest) {
  constexpr std::uint64_t states = 5;  // separated, inactive, sticking, sliding in either direction
  std::uint64_t maximum = 1;
  for (int i = 0; i < candidates && maximum < 2 * longest; ++i) maximum *= states;
  return rays::bytes_for(std::min(maximum, 2 * longest), candidates);
}

RayListTree::RayListTree(SignPatternTree tree, rays::ReactionCone cone, rays::RayList list,
                         std::uint64_t longest)
    : tree_(std::move(tree)), cone_(std::move(cone)), list_(std::move(list)), longest_(longest) {
  tree_.end_when(interruption_.stop());
}

RayTally RayListTree::tally() const {
  RayTally all = tally_;
  all.patterns = patterns_before_ ? *patterns_before_ : tree_.tally();
  return all;
}

// An infeasible part has no ray. A degenerate one that is closed without a leaf has no ray with a
// reaction at every candidate in contact.
bool RayListTree::may_have_own(const Node& list) {
  if ((list.contact | list.separated) == 0) return true;
  const auto decision = tree_.decide({.block = 0, .pattern = {list.contact, list.separated, {}}});
  return decision.leaf || !decision.children.empty();
}

RayListTree::Node RayListTree::continued(const Node& list) {
  auto next = list;
  const auto steps =
      rays::resume(next, cone_, {.max_rays = longest_, .stop = interruption_.stop()});
  if (steps.stopped) throw support::Stopped();
  tally_.cost += steps.cost;
  tally_.health += steps.health;
  return next;
}

void RayListTree::expand(Node&& node, engine::Expansion<RayListTree>& out) {
  patterns_before_ = tree_.tally();
  auto list = interruption_.within(out, node,
                                   [&] { return may_have_own(node) ? continued(node) : Node(); });
  if (!list) return;
  patterns_before_.reset();
  node = {};  // releases the memory
  if (list->zeros.empty()) return;
  if (rays::has_ended(*list, cone_)) {
    PatternRays own{own_rays(list->zeros, list->contact, list->separated, cone_.all())};
    report(std::move(own), static_cast<bool>(keep_), out);
    return;
  }
  auto parts = rays::divided(*list);
  list.reset();
  for (auto& part : *parts) out.branch(std::move(part));
}

bool RayListTree::emit(const engine::Path& /*path*/, Solution& own) {
  if (!keep_) return false;
  for (const auto& zero : own.rays) keep_(zero, cone_.ray(zero, tally_.health));
  return true;
}

}  // namespace kusabi::wedged

template kusabi::engine::OutcomeOf<kusabi::wedged::RayListTree> kusabi::engine::search(
    kusabi::wedged::RayListTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
