// All ranks have all rays and share large steps, or they share the tree.
#include "nodes/wedged/ray_search.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "engine/shared_work.hpp"
#include "engine/together.hpp"
#include "nodes/wedged/ray_trial.hpp"
#include "problems/wedged/precise_compliance.hpp"

namespace kusabi::wedged {
namespace {

/// Memory that `automatic` lets double description take on each rank, about what a core has. Where
/// it fits into this it has been as fast as the tree on one rank, and up to twelve times as fast;
/// where it does not, its rays grow threefold with each candidate, and the tree's twofold from a
/// tenth of them (bench/README.md). By the number of rays met, so that the method does not depend
/// on ranks or clocks.
constexpr std::uint64_t memory_for_double_description = std::uint64_t{2} << 30U;

/// What comes after double description.
enum class Way { done, stopped, by_tree };

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

// Rays are known by their zeros at all candidates, so the blocks stay together.
SignPatternTree whole_tree(const problems::WedgedProblem& problem,
                           std::span<const double> friction) {
  problems::WedgedProblem whole = problem;
  whole.blocks.clear();
  return {whole, friction};
}

RayFindings by_tree(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                    std::span<const double> friction, const rays::ReactionCone& cone) {
  RayTree tree(whole_tree(problem, friction), cone);
  auto outcome = campaign.search(tree, {});
  if (campaign.is_first()) return gathered(outcome);
  return {};
}

// Nothing if it was stopped, which is for rank 0 to say, or there are too many rays at one time.
std::optional<RayFindings> by_double_description(engine::Campaign& campaign,
                                                 const rays::ReactionCone& cone,
                                                 std::uint64_t most_rays, RayTrial* trial) {
  const auto start = std::chrono::steady_clock::now();
  auto& transport = campaign.transport();
  rays::Conduct conduct{.most_rays = most_rays};
  if (campaign.is_first()) conduct.stop = campaign.budget().stop();
  if (trial != nullptr) {
    conduct.give_up = [&transport, trial](const rays::Effort& effort) {
      return engine::from_first_rank(transport, [&] { return trial->succeeds(effort.pairs); });
    };
  }
  if (transport.size() > 1) {
    conduct.share = [&](std::uint64_t count, const auto& piece) {
      return engine::share_work<rays::NewRays>(transport, count, piece);
    };
    conduct.agree = [&](bool told) {
      return engine::from_first_rank(transport, [&] { return told; });
    };
  }
  auto enumeration = rays::complementary_rays(cone, conduct);
  if (!enumeration) return std::nullopt;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  RayFindings found;
  found.rays = std::move(enumeration->rays);
  found.health = enumeration->health;
  found.effort = enumeration->effort;
  found.seconds = time.count();
  return found;
}

// Double description has them among its rays, the tree does not come to them.
void find_motions(RayFindings& found, const rays::ReactionCone& cone) {
  if (cone.pivots().empty()) return;
  std::erase_if(found.rays, [&](const rays::ZeroSet& zero) {
    return rays::Supports(zero, cone.all()).reaction() == 0;
  });
  auto motions = rays::rays_of_pattern(cone, 0);
  found.health += motions.health;
  found.motions = std::move(motions.rays);
  std::sort(found.motions.begin(), found.motions.end(), rays::comes_before);
}

// A cone of configurations may have gaps that a motion opens; one of motions alone is not wedged.
void find_cones(RayFindings& found, const rays::ReactionCone& cone) {
  auto all = found.rays;
  all.insert(all.end(), found.motions.begin(), found.motions.end());
  found.cones = rays::maximal_cones(all, cone.all());
  std::erase_if(found.cones, [](const rays::Cone& each) { return each.reaction == 0; });
}

}  // namespace

bool limited(const engine::Limits& limits) {
  const engine::Limits none;
  return limits.seconds != none.seconds || limits.nodes != none.nodes;
}

RayMethod first_method(RayMethod asked, const engine::Limits& limits) {
  if (asked != RayMethod::automatic) return asked;
  return limited(limits) ? RayMethod::tree : RayMethod::double_description;
}

rays::ReactionCone reaction_cone(const problems::Structure& structure,
                                 const problems::WedgedProblem& problem,
                                 std::span<const double> friction) {
  return {problems::precise_compliance(structure), friction,
          problem.precise_motions.cast<long double>()};
}

RayFindings find_rays(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                      std::span<const double> friction, const rays::ReactionCone& cone,
                      RayMethod method) {
  if (cone.equations() != problem.motions.cols())
    throw std::invalid_argument("the cone of reactions is not that of the loose bodies");
  RayFindings found;
  const auto& budget = campaign.budget();
  bool by_all = first_method(method, budget.left()) == RayMethod::tree;
  if (!by_all) {
    const bool either = method == RayMethod::automatic;
    const auto most = either ? rays::rays_that_fit(memory_for_double_description, cone.candidates())
                             : std::numeric_limits<std::uint64_t>::max();
    RayTrial trial([&] { return whole_tree(problem, friction); }, cone, budget.stop());
    auto all = by_double_description(campaign, cone, most, either ? &trial : nullptr);
    if (!all && trial.has_succeeded()) all = std::move(trial).found();
    const Way way = engine::from_first_rank(campaign.transport(), [&] {
      return all ? Way::done : budget.spent() ? Way::stopped : Way::by_tree;
    });
    by_all = way == Way::by_tree;
    if (all) found = *std::move(all);
    if (way == Way::stopped) found.status = budget.why();
    if (by_all) {
      campaign.say(
          fmt::format("more than {} rays at one time: by the tree of sign patterns", most));
    }
  }
  if (by_all) found = by_tree(campaign, problem, friction, cone);
  if (!campaign.is_first()) return found;
  find_motions(found, cone);
  std::sort(found.rays.begin(), found.rays.end(), rays::comes_before);
  if (found.status == engine::Status::solved) find_cones(found, cone);
  return found;
}

}  // namespace kusabi::wedged
