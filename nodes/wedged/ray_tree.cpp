// What a leaf of the tree of sign patterns is worth here.
#include "nodes/wedged/ray_tree.hpp"

#include <utility>

namespace kusabi::wedged {

RayTally& RayTally::operator+=(const RayTally& other) {
  patterns += other.patterns;
  effort += other.effort;
  health += other.health;
  return *this;
}

RayTree::RayTree(SignPatternTree tree, rays::ReactionCone cone, RayTreeBudget budget)
    : tree_(std::move(tree)), cone_(std::move(cone)), budget_(std::move(budget)) {}

RayTally RayTree::tally() const {
  RayTally all = tally_;
  all.patterns = tree_.tally();
  return all;
}

void RayTree::expand(Node&& node, engine::Expansion<RayTree>& out) {
  gave_up_ = gave_up_ || opened_ >= budget_.nodes || tally_.effort.pairs > budget_.pairs ||
             (budget_.stop && budget_.stop());
  if (gave_up_) return;
  ++opened_;
  const auto fate = tree_.decide(node);
  for (const Node& child : fate.children) out.branch(child);
  if (!fate.leaf) return;
  out.poll();
  const auto& [contact, separated, at_rest] = node.pattern;
  const bool flat = fate.leaf->state == LeafState::flat;
  const auto found = rays::rays_of_pattern(cone_, flat ? fate.leaf->pattern.contact : contact);
  tally_.effort += found.effort;
  tally_.health += found.health;
  PatternRays own;
  for (const rays::ZeroSet& zero : found.rays) {
    // Those with a reaction just at the candidates in contact of a sign pattern below this node.
    const auto loaded = rays::Supports(zero, cone_.all()).reaction();
    if ((contact & ~loaded) == 0 && (separated & loaded) == 0) own.rays.push_back(zero);
  }
  if (!own.rays.empty()) out.solution(std::move(own));
}

}  // namespace kusabi::wedged
