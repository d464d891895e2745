// One rank alone, or the tree on all.
#include "nodes/wedged/ray_search.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace kusabi::wedged {
namespace {

/// Up to so many candidates double description is two to four times as fast as the tree on one
/// rank, and takes less than a gigabyte; beyond, its memory grows threefold with each candidate,
/// and the tree's twofold from a tenth of it (bench/README.md).
constexpr int most_for_double_description = 14;

RayFindings by_double_description(const rays::ReactionCone& cone) {
  const auto start = std::chrono::steady_clock::now();
  auto enumeration = rays::complementary_rays(cone);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  RayFindings found;
  found.rays = std::move(enumeration.rays);
  found.health = enumeration.health;
  found.effort = enumeration.effort;
  found.seconds = time.count();
  return found;
}

// What rank 0 makes of the outcome of the tree.
RayFindings gathered(engine::Outcome<RayTree>& outcome) {
  RayFindings found;
  found.method = RayMethod::tree;
  found.status = outcome.status;
  for (auto& leaf : outcome.solutions) {
    auto& own = leaf.solution.rays;
    found.rays.insert(found.rays.end(), own.begin(), own.end());
    own = {};  // the memory is needed
  }
  const auto total = outcome.tally();
  found.health = total.health;
  found.tree = RayTreeReport{.patterns = total.patterns,
                             .opened = outcome.opened(),
                             .open = outcome.open,
                             .fingerprint = outcome.fingerprint(),
                             .ranks = std::move(outcome.ranks)};
  return found;
}

RayFindings by_tree(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                    std::span<const double> friction, const rays::ReactionCone& cone) {
  // Rays are known by their zeros at all candidates, so the blocks stay together.
  problems::WedgedProblem whole = problem;
  whole.blocks.clear();
  RayTree tree(SignPatternTree(whole, friction), cone);
  auto outcome = campaign.search(tree, {});
  if (campaign.is_first()) return gathered(outcome);
  return {};
}

}  // namespace

bool limited(const engine::Limits& limits) {
  const engine::Limits none;
  return limits.seconds != none.seconds || limits.nodes != none.nodes;
}

RayMethod chosen_method(RayMethod asked, const engine::Limits& limits, int candidates) {
  if (asked != RayMethod::automatic) return asked;
  const bool small = candidates <= most_for_double_description && !limited(limits);
  return small ? RayMethod::double_description : RayMethod::tree;
}

RayFindings find_rays(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                      std::span<const double> friction, const rays::ReactionCone& cone,
                      RayMethod method) {
  RayFindings found;
  if (method == RayMethod::tree) {
    found = by_tree(campaign, problem, friction, cone);
  } else if (campaign.is_first()) {
    found = by_double_description(cone);
  }
  if (!campaign.is_first()) return found;
  std::sort(found.rays.begin(), found.rays.end(), rays::comes_before);
  if (found.status == engine::Status::solved) {
    found.cones = rays::maximal_cones(found.rays, cone.all());
  }
  return found;
}

}  // namespace kusabi::wedged
