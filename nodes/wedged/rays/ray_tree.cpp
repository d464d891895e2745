// Rays of the leaves of the tree of sign patterns.
#include "nodes/wedged/rays/ray_tree.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Core>

#include "engine/search.hpp"
#include "solvers/rays/edge_walk.hpp"
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
  report(std::move(opened->own), static_cast<bool>(keep_), out);
}

bool RayTree::emit(const engine::Path& /*path*/, Solution& own) {
  if (!keep_) return false;
  for (const auto& zero : own.rays) keep_(zero, cone_.ray(zero, tally_.health));
  return true;
}

RayTree::Opened RayTree::open(const Node& node) {
  Opened opened{tree_.decide(node), {}};
  if (!opened.decision.leaf) return opened;
  const auto leaf = RayLeaf::of(node, opened.decision);
  opened.own = {leaf.own(rays_of(*opened.decision.leaf, leaf.in_contact), cone_.all())};
  return opened;
}

// A feasible leaf has a point inside its cone, where the walk begins.
std::vector<rays::ZeroSet> RayTree::rays_of(const Configuration& leaf,
                                            rays::Candidates in_contact) {
  if (leaf.state == LeafState::feasible) {
    const Eigen::Map<const Eigen::VectorXd> reaction(leaf.reaction.data(),
                                                     std::ssize(leaf.reaction));
    auto walk = rays::walk_along_edges(cone_, in_contact, cone_.unknowns_of(reaction),
                                       interruption_.stop());
    if (walk.end == rays::WalkEnd::stopped) throw support::Stopped();
    tally_.cost += {.peak_rays = walk.rays.size()};
    if (walk.end == rays::WalkEnd::complete) return std::move(walk.rays);
  }
  auto found = rays::rays_of_pattern(cone_, in_contact, interruption_.stop());
  if (!found) throw support::Stopped();
  tally_.cost += found->cost;
  tally_.health += found->health;
  return std::move(found->rays);
}

}  // namespace kusabi::wedged

template kusabi::engine::OutcomeOf<kusabi::wedged::RayTree> kusabi::engine::search(
    kusabi::wedged::RayTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
