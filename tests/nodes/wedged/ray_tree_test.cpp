// Equality of the rays found for each pattern and those of Algorithm 4.2.
#include "nodes/wedged/rays/ray_tree.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "nodes/wedged/rays/ray_list_tree.hpp"
#include "nodes/wedged/rays/ray_trial.hpp"
#include "problems/families/plane_truss.hpp"
#include "problems/wedged/precise_compliance.hpp"

namespace kusabi::wedged {
namespace {

std::vector<rays::ZeroSet> sorted(std::vector<rays::ZeroSet> list) {
  std::sort(list.begin(), list.end(), rays::comes_before);
  return list;
}

TEST(RayTree, FindsTheRaysOfTheDoubleDescription) {
  using problems::PlaneTrussSize;
  // The trusses of one bay have inactive candidates: their cones are flat, and rays that no
  // feasible pattern reports have flat cones, too.
  for (const PlaneTrussSize& size :
       {PlaneTrussSize{.rows = 8}, PlaneTrussSize{.rows = 7, .bays = 1},
        PlaneTrussSize{.rows = 7, .bays = 3}}) {
    for (const double mu : {0.65, 1.0}) {
      const auto truss = problems::plane_truss(size);
      auto problem = problems::wedged_problem(checked(truss));
      problem.blocks.clear();  // rays are those of the whole
      const std::vector<double> friction(problem.friction.size(), mu);
      const rays::ReactionCone cone(problems::precise_compliance(problem), friction);
      RayTree tree(SignPatternTree(problem, friction), cone);
      const auto outcome = engine::search(tree);
      std::vector<rays::ZeroSet> together;
      for (const auto& leaf : outcome.solutions) {
        const auto& own = leaf.solution.rays;
        together.insert(together.end(), own.begin(), own.end());
      }
      const auto whole = rays::complementary_rays(cone);
      EXPECT_EQ(sorted(together), sorted(whole.rays)) << size.rows << ' ' << size.bays << ' ' << mu;
      EXPECT_TRUE(tree.tally().health.sound());
      EXPECT_LE(tree.tally().cost.peak_rays, whole.cost.peak_rays);
    }
  }
}

/// A problem of rays, and its solution by double description.
struct RayProblem {
  explicit RayProblem(const problems::Structure& truss, double mu = 0.65)
      : problem(problems::wedged_problem(checked(truss))),
        friction(problem.friction.size(), mu),
        cone(problems::precise_compliance(problem), friction) {
    problem.blocks.clear();
  }

  [[nodiscard]] RayTrial trial() const {
    return {[this] { return SignPatternTree(problem, friction); }, cone, {}};
  }

  problems::WedgedProblem problem;
  std::vector<double> friction;
  rays::ReactionCone cone;
};

constexpr std::uint64_t no_end = std::uint64_t{1} << 40U;

// Each ray, with its numbers, reaches the recorder once; the outcome counts all and keeps none.
void expect_recorded(auto tree, const RayProblem& given) {
  std::vector<rays::ZeroSet> recorded;
  tree.keep_found([&](const rays::ZeroSet& zero, const rays::Ray& ray) {
    rays::Health health;
    EXPECT_EQ(ray.reaction, given.cone.ray(zero, health).reaction);
    recorded.push_back(zero);
  });
  const auto outcome = engine::search(tree);
  EXPECT_TRUE(outcome.solutions.empty());
  EXPECT_EQ(outcome.total().found, recorded.size());
  EXPECT_EQ(sorted(recorded), sorted(rays::complementary_rays(given.cone).rays));
  EXPECT_LT(tree.tally().health.smallest_nonzero, 1);
}

TEST(RayTree, PassesItsRaysToARecorder) {
  const RayProblem given(problems::plane_truss({.rows = 8}));
  expect_recorded(RayTree(SignPatternTree(given.problem, given.friction), given.cone), given);
  constexpr std::uint64_t longest = 100;  // divides the list of 170 rays
  expect_recorded(RayListTree(SignPatternTree(given.problem, given.friction), given.cone,
                              rays::first_list(given.cone), longest),
                  given);
}

TEST(RayTrial, HasAllRaysIfItSucceeds) {
  for (const auto& truss : {problems::plane_truss({.rows = 9}), problems::paper_plane_truss(11)}) {
    const RayProblem given(truss);
    auto trial = given.trial();
    ASSERT_TRUE(trial.succeeds(no_end));
    ASSERT_TRUE(trial.has_succeeded());
    const auto found = std::move(trial).found();
    EXPECT_EQ(sorted(found.rays), sorted(rays::complementary_rays(given.cone).rays));
    EXPECT_TRUE(found.health.sound());
  }
}

TEST(RayTrial, SucceedsOnSmallTreesOnly) {
  // With almost all bars no pattern is feasible, and double description has many intermediate rays;
  // the paper's truss has many degenerate nodes, and few more intermediate rays than final ones.
  const auto outlasts = [](const problems::Structure& truss) {
    const RayProblem given(truss);
    auto trial = given.trial();
    rays::EnumerationOptions options;
    options.give_up = [&](const rays::Cost& cost) { return trial.succeeds(cost.pairs); };
    const bool ended = rays::complementary_rays(given.cone, options).has_value();
    EXPECT_NE(ended, trial.has_succeeded());
    return ended;
  };
  EXPECT_FALSE(
      outlasts(problems::plane_truss({.rows = 14, .verticals = problems::Verticals::all})));
  EXPECT_TRUE(outlasts(problems::paper_plane_truss(16)));
}

/// Result and costs with lists of limited length.
struct Divided {
  Divided(const RayProblem& given, std::uint64_t longest) {
    RayListTree tree(SignPatternTree(given.problem, given.friction), given.cone,
                     rays::first_list(given.cone), longest);
    const auto outcome = engine::search(tree);
    for (const auto& leaf : outcome.solutions) {
      const auto& own = leaf.solution.rays;
      rays.insert(rays.end(), own.begin(), own.end());
    }
    rays = sorted(std::move(rays));
    opened = outcome.opened();
    tally = outcome.tally();
  }

  std::vector<rays::ZeroSet> rays;
  std::uint64_t opened = 0;
  RayTally tally;
};

// Down to lists that are divided wherever possible.
TEST(RayListTree, FindsTheSameRaysForAnyDivisionOfTheList) {
  std::uint64_t opened = 0;  // by 24 searches, most of which divide the list
  for (const auto& truss :
       {problems::plane_truss({.rows = 9}), problems::plane_truss({.rows = 8, .bays = 1}),
        problems::plane_truss({.rows = 9, .verticals = problems::Verticals::all}),
        problems::paper_plane_truss(11)}) {
    for (const double mu : {0.65, 1.0}) {
      const RayProblem given(truss, mu);
      const auto whole = rays::complementary_rays(given.cone);
      for (const std::uint64_t longest : {0, 30, 150}) {
        const Divided parts(given, longest);
        EXPECT_EQ(parts.rays, sorted(whole.rays)) << longest << ' ' << mu;
        opened += parts.opened;
        EXPECT_LE(parts.tally.cost.peak_rays, whole.cost.peak_rays);
        EXPECT_TRUE(parts.tally.health.sound());
      }
    }
  }
  EXPECT_GE(opened, 60U);
}

TEST(RayListTree, ListsHaveBoundedMemory) {
  EXPECT_LT(memory_of_lists(3, longest_list), 1'000'000U);
  EXPECT_LT(memory_of_lists(5, longest_list), memory_of_lists(10, longest_list));
  EXPECT_LT(memory_of_lists(64, longest_list), std::uint64_t{2} << 30U);
}

TEST(PatternRaysByTurns, AreTheSameInAnyNumberOfTurns) {
  const RayProblem given(problems::plane_truss({.rows = 10}));
  const rays::Candidates all = given.cone.all();
  for (const rays::Candidates contact : {all, all & ~rays::bit(3), rays::Candidates{0b111}}) {
    rays::PatternRaysByTurns turns(given.cone, contact);
    int pauses = 0;
    for (std::uint64_t maximum = 0; !turns.resume(maximum); maximum += 20) ++pauses;
    if (contact == all) {
      EXPECT_GT(pauses, 5);
    }
    const auto once = rays::rays_of_pattern(given.cone, contact);
    EXPECT_EQ(sorted(std::move(turns).result().rays), sorted(once.rays));
  }
}

}  // namespace
}  // namespace kusabi::wedged
