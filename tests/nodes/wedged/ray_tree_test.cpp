// The rays pattern by pattern are those of Algorithm 4.2.
#include "nodes/wedged/ray_tree.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "engine/search.hpp"
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
  // The trusses of one bay have idle candidates: their cones are flat, and so are those of rays
  // that no living pattern reports.
  for (const PlaneTrussSize& size :
       {PlaneTrussSize{.rows = 8}, PlaneTrussSize{.rows = 7, .bays = 1},
        PlaneTrussSize{.rows = 7, .bays = 3}}) {
    for (const double mu : {0.65, 1.0}) {
      const auto truss = problems::plane_truss(size);
      auto problem = problems::wedged_problem(truss);
      problem.blocks.clear();  // rays are those of the whole
      const std::vector<double> friction(problem.friction.size(), mu);
      const rays::ReactionCone cone(problems::precise_compliance(truss), friction);
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
      EXPECT_LE(tree.tally().effort.peak_rays, whole.effort.peak_rays);
    }
  }
}

}  // namespace
}  // namespace kusabi::wedged
