// Rays of the leaves of the tree of sign patterns.
#include "nodes/wedged/rays/ray_tree.hpp"

#include <utility>

namespace kusabi::wedged {

RayTally& RayTally::operator+=(const RayTally& other) {
  patterns += other.patterns;
  effort += other.effort;
  health += other.health;
  return *this;
}

RayLeaf RayLeaf::of(const PatternNode& node, const SignPatternTree::Fate& fate) {
  const bool flat = fate.leaf->state == LeafState::flat;
  return {node.pattern, (flat ? fate.leaf->pattern.contact : node.pattern.contact).word(0)};
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
    : tree_(std::move(tree)), cone_(std::move(cone)) {}

RayTally RayTree::tally() const {
  RayTally all = tally_;
  all.patterns = tree_.tally();
  return all;
}

void RayTree::expand(Node&& node, engine::Expansion<RayTree>& out) {
  const auto fate = tree_.decide(node, out);
  if (!fate) return;
  for (const Node& child : fate->children) out.branch(child);
  if (!fate->leaf) return;
  out.poll();
  const auto leaf = RayLeaf::of(node, *fate);
  const auto found = rays::rays_of_pattern(cone_, leaf.in_contact);
  tally_.effort += found.effort;
  tally_.health += found.health;
  PatternRays own{leaf.own(found.rays, cone_.all())};
  if (!own.rays.empty()) out.solution(std::move(own));
}

}  // namespace kusabi::wedged
