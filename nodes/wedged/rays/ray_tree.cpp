// Rays of the leaves of the tree of sign patterns.
#include "nodes/wedged/rays/ray_tree.hpp"

#include <utility>

#include "engine/search.hpp"
#include "support/stop.hpp"

namespace kusabi::wedged {

RayTally& RayTally::operator+=(const RayTally& other) {
  patterns += other.patterns;
  cost += other.cost;
  health += other.health;
  return *this;
}

RayLeaf RayLeaf::of(const PatternNode& node, const SignPatternTree::NodeResult& decision) {
  const bool flat = decision.leaf->state == LeafState::flat;
  return {node.pattern, (flat ? decision.leaf->pattern.contact : node.pattern.contact).word(0)};
}

std::vector<rays::ZeroSet> own_rays(const std::vector<rays::ZeroSet>& rays,
                                    rays::Candidates contact, rays::Candidates separated,
                                    rays::Candidates all) {
  std::vector<rays::ZeroSet> own;
  for (const rays::ZeroSet& zero : rays) {
    const auto loaded = rays::Supports(zero, all).reaction();
    if (loaded == 0) continue;  // a rigid-body mode alone
    if ((contact & ~loaded) == 0 && (separated & loaded) == 0) own.push_back(zero);
  }
  return own;
}

RayTree::RayTree(SignPatternTree tree, rays::ReactionCone cone)
    : tree_(std::move(tree)), cone_(std::move(cone)) {
  tree_.end_when(interruption_.stop());
}

RayTally RayTree::tally() const {
  RayTally all = tally_;
  all.patterns = patterns_before_ ? *patterns_before_ : tree_.tally();
  return all;
}

void RayTree::expand(Node&& node, engine::Expansion<RayTree>& out) {
  patterns_before_ = tree_.tally();
  auto opened = interruption_.within(out, node, [&] { return open(node); });
  if (!opened) return;
  patterns_before_.reset();
  for (const Node& child : opened->decision.children) out.branch(child);
  if (!opened->own.rays.empty()) out.solution(std::move(opened->own));
}

RayTree::Opened RayTree::open(const Node& node) {
  Opened opened{tree_.decide(node), {}};
  if (!opened.decision.leaf) return opened;
  const auto leaf = RayLeaf::of(node, opened.decision);
  const auto found = rays::rays_of_pattern(cone_, leaf.in_contact, interruption_.stop());
  if (!found) throw support::Stopped();
  tally_.cost += found->cost;
  tally_.health += found->health;
  opened.own = {leaf.own(found->rays, cone_.all())};
  return opened;
}

}  // namespace kusabi::wedged

template kusabi::engine::OutcomeOf<kusabi::wedged::RayTree> kusabi::engine::search(
    kusabi::wedged::RayTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
