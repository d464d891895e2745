// Common initial steps on all ranks, then division of a long list, or the tree of sign patterns.
#include "nodes/wedged/rays/ray_search.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "engine/analysis/shared_work.hpp"
#include "engine/collectives.hpp"
#include "nodes/wedged/rays/ray_list_tree.hpp"
#include "nodes/wedged/rays/ray_trial.hpp"
#include "problems/wedged/precise_compliance.hpp"

namespace kusabi::wedged {
namespace {

/// Continuation after the common steps of all ranks.
enum class Continuation { done, stopped, divided, tree };

// Result on rank 0 from the outcome of either tree.
// @param keeps a recorder has taken the rays
template <class Tree>
RayFindings gathered(engine::Outcome<Tree>& outcome, bool keeps) {
  RayFindings found;
  found.status = outcome.status;
  for (auto& leaf : outcome.solutions) {
    auto& own = leaf.solution.rays;
    found.rays.insert(found.rays.end(), own.begin(), own.end());
    own = {};  // releases the memory
  }
  const auto total = outcome.tally();
  found.health = total.health;
  if (keeps) found.kept = outcome.total().found;
  found.tree = RayTreeReport{.patterns = total.patterns,
                             .opened = outcome.opened(),
                             .open = outcome.open,
                             .fingerprint = outcome.fingerprint(),
                             .ranks = {}};
  for (const auto& [statistics, tally] : outcome.ranks)
    found.tree->ranks.push_back({.statistics = statistics, .tally = tally});
  return found;
}

// Rays are identified by their zeros at all candidates, so blocks are not separated.
SignPatternTree whole_tree(const problems::WedgedProblem& problem,
                           std::span<const double> friction) {
  problems::WedgedProblem whole = problem;
  whole.blocks.clear();
  return {whole, friction};
}

template <class Tree>
RayFindings searched(engine::Analysis& analysis, Tree tree, const RayRecorder& recorder) {
  if (recorder) tree.keep_found(recorder);
  auto outcome = analysis.search(tree, {});
  if (analysis.is_first()) return gathered(outcome, static_cast<bool>(recorder));
  return {};
}

RayFindings by_tree(engine::Analysis& analysis, SignPatternTree tree,
                    const rays::ReactionCone& cone, const RayRecorder& recorder) {
  auto found = searched(analysis, RayTree(std::move(tree), cone), recorder);
  found.method = RayMethod::tree;
  return found;
}

// Common steps of all ranks until double description is complete, the run is stopped, or the list
// is longer than `maximum`. Each rank ends its pieces by itself; rank 0 decides between the steps.
rays::StepsResult steps_of_all(engine::Analysis& analysis, const rays::ReactionCone& cone,
                               rays::RayList& list, std::uint64_t maximum, RayTrial* trial) {
  auto& transport = analysis.transport();
  rays::EnumerationOptions options{.max_rays = maximum, .stop = analysis.budget().stop()};
  if (trial != nullptr) {
    options.give_up = [&transport, trial](const rays::Cost& cost) {
      return engine::from_first_rank(transport, [&] { return trial->succeeds(cost.pairs); });
    };
  }
  if (transport.size() > 1) {
    options.share = [&](std::uint64_t count, const auto& piece) {
      return engine::share_work<rays::NewRays>(transport, count, piece);
    };
    options.agree = [&](bool own) {
      return engine::from_first_rank(transport, [&] { return own; });
    };
  }
  return rays::resume(list, cone, options);
}

// Divides a long list, and adds the costs of the previous steps.
RayFindings by_parts(engine::Analysis& analysis, SignPatternTree tree,
                     const rays::ReactionCone& cone, rays::RayList list,
                     const rays::StepsResult& before, const RayRecorder& recorder) {
  analysis.say(fmt::format("{} rays at one time: the list is divided", list.zeros.size()));
  const auto longest = recorder ? longest_recorded_list : longest_list;
  auto found =
      searched(analysis, RayListTree(std::move(tree), cone, std::move(list), longest), recorder);
  if (!analysis.is_first()) return found;
  found.health += before.health;
  found.tree->ranks.front().tally.cost += before.cost;
  return found;
}

// Pairs until a list of `longest_list` rays, from those until one of a smaller maximum: they grow
// with the square of the length.
std::uint64_t pairs_of_long_list(std::uint64_t pairs, std::uint64_t maximum) {
  const auto ratio = longest_list / maximum;
  return ratio * ratio * pairs;
}

RayFindings by_double_description(engine::Analysis& analysis,
                                  const problems::WedgedProblem& problem,
                                  std::span<const double> friction, const rays::ReactionCone& cone,
                                  RayMethod method, const RayRecorder& recorder) {
  const auto start = std::chrono::steady_clock::now();
  const bool either = method == RayMethod::automatic;
  const auto maximum = !either    ? std::numeric_limits<std::uint64_t>::max()
                       : recorder ? longest_recorded_list
                                  : longest_list;
  RayTrial trial([&] { return whole_tree(problem, friction); }, cone, analysis.budget().stop());
  auto list = rays::first_list(cone);
  const auto steps = steps_of_all(analysis, cone, list, maximum, either ? &trial : nullptr);
  const Continuation way = engine::from_first_rank(analysis.transport(), [&] {
    return trial.has_succeeded() || (!steps.stopped && rays::has_ended(list, cone))
               ? Continuation::done
           : steps.stopped ? Continuation::stopped
           : trial.is_worth_searching(pairs_of_long_list(steps.cost.pairs, maximum))
               ? Continuation::tree
               : Continuation::divided;
  });
  if (way == Continuation::tree) {
    list = {};  // releases the memory
    return by_tree(analysis, whole_tree(problem, friction), cone, recorder);
  }
  if (way == Continuation::divided)
    return by_parts(analysis, whole_tree(problem, friction), cone, std::move(list), steps,
                    recorder);
  RayFindings found;
  if (!analysis.is_first()) return found;
  if (trial.has_succeeded()) return std::move(trial).found();
  if (way == Continuation::stopped) {
    found.status = analysis.budget().stop_reason();
    return found;
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  found.rays = std::move(list.zeros);
  found.health = steps.health;
  found.cost = steps.cost;
  found.seconds = time.count();
  return found;
}

// Double description lists these modes among its rays; the tree does not find them.
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

}  // namespace

bool limited(const engine::Limits& limits) {
  const engine::Limits none;
  return limits.seconds != none.seconds || limits.nodes != none.nodes;
}

rays::ReactionCone reaction_cone(const problems::WedgedProblem& problem,
                                 std::span<const double> friction) {
  return {problems::precise_compliance(problem), friction,
          problem.modes.precise.cast<long double>()};
}

RayFindings find_rays(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                      std::span<const double> friction, const rays::ReactionCone& cone,
                      RayMethod method, const RayRecorder& recorder) {
  if (cone.equations() != problem.modes.matrix.cols())
    throw std::invalid_argument("the cone of reactions is not that of the unconstrained bodies");
  auto found = method == RayMethod::tree
                   ? by_tree(analysis, whole_tree(problem, friction), cone, recorder)
                   : by_double_description(analysis, problem, friction, cone, method, recorder);
  if (!analysis.is_first()) return found;
  find_motions(found, cone);
  std::sort(found.rays.begin(), found.rays.end(), rays::comes_before);
  if (recorder) return found;
  rays::ConesOfRays cones;
  for (const auto& zero : found.rays) cones.add(rays::cone_of({zero, cone.all()}));
  find_cones(found, std::move(cones), cone.all(), analysis.budget());
  return found;
}

// Cones of configurations include gaps opened by a rigid-body mode; a cone of modes alone is not
// wedged.
void find_cones(RayFindings& found, rays::ConesOfRays of_rays, rays::Candidates all,
                const engine::Budget& budget) {
  if (found.status != engine::Status::solved) return;
  for (const auto& zero : found.motions) of_rays.add(rays::cone_of({zero, all}));
  auto cones = rays::maximal_cones(std::move(of_rays), all, budget.stop());
  if (!cones) {
    found.status = budget.stop_reason();
    return;
  }
  found.cones = *std::move(cones);
  std::erase_if(found.cones, [](const rays::Cone& each) { return each.reaction == 0; });
}

}  // namespace kusabi::wedged
