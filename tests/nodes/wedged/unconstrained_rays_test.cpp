// Rays of unconstrained bodies: the methods agree with each other, with the tree of sign patterns,
// and with statics.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/wedged/rays/ray_search.hpp"
#include "nodes/wedged/tree/maximal_cones.hpp"
#include "random_truss.hpp"
#include "wheel.hpp"

namespace kusabi::wedged {
namespace {

/// (S, G): candidates with reactions and with gaps in a cone.
using Cones = std::set<std::pair<support::IndexSet, support::IndexSet>>;

RayFindings rays_of(const problems::Structure& structure, double mu, RayMethod method) {
  const auto problem = problems::wedged_problem(checked(structure));
  const std::vector<double> friction(problem.contact_names.size(), mu);
  const auto cone = reaction_cone(problem, friction);
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  return find_rays(analysis, problem, friction, cone, method);
}

// A truss without supports, surrounded by obstacles.
problems::Structure unconstrained_truss(int candidates, std::mt19937_64& bits) {
  auto truss = testing::random_truss(
      {.candidates = candidates, .free_nodes = candidates + 1, .density = 1}, bits);
  const auto free = static_cast<std::size_t>(candidates) + 1;
  truss.coordinates.conservativeResize(2, candidates + 1);
  truss.node_names.resize(free);
  truss.fixed.resize(free);
  std::erase_if(truss.members,
                [&](const auto& bar) { return std::max(bar.first, bar.second) > candidates; });
  std::uniform_real_distribution<double> turn(-0.5, 0.5);
  for (auto& candidate : truss.contact) {
    const Eigen::Vector2d place = truss.coordinates.col(candidate.node);
    candidate.normal = (-place + Eigen::Vector2d(turn(bits), turn(bits))).normalized();
  }
  return truss;
}

TEST(UnconstrainedRays, AreTheSameByBothMethodsAndTheirCliquesAreThePatterns) {
  std::mt19937_64 bits(3);
  std::size_t rays = 0;
  std::size_t cones = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const auto truss = unconstrained_truss(3 + trial % 4, bits);
    const auto problem = problems::wedged_problem(checked(truss));
    ASSERT_EQ(problem.modes.matrix.cols(), 3);
    const double mu = trial % 2 == 0 ? 0.5 : 1.2;
    const auto found = rays_of(truss, mu, RayMethod::double_description);
    const auto by_tree = rays_of(truss, mu, RayMethod::tree);
    EXPECT_TRUE(found.health.sound());
    EXPECT_EQ(found.rays, by_tree.rays) << trial;
    EXPECT_EQ(found.motions, by_tree.motions);
    EXPECT_EQ(found.cones, by_tree.cones);
    SignPatternTree tree(problem, std::vector<double>(problem.contact_names.size(), mu));
    std::vector<Configuration> leaves;
    for (auto& leaf : engine::search(tree).solutions) leaves.push_back(std::move(leaf.solution));
    Cones patterns;
    for (const auto& leaf : maximal_cones(std::move(leaves))) {
      ASSERT_TRUE(leaf.state == LeafState::feasible || leaf.state == LeafState::flat) << trial;
      patterns.emplace(leaf.pattern.contact, leaf.pattern.separated);
    }
    Cones cliques;
    for (const auto& each : found.cones) cliques.emplace(each.reaction, each.separated);
    EXPECT_EQ(cliques, patterns) << trial;
    rays += found.rays.size();
    cones += found.cones.size();
  }
  EXPECT_GT(rays, 100U);
  EXPECT_GT(cones, 50U);
}

// A bar between walls that lean by 20 degrees to either side: two opposite forces along it.
TEST(UnconstrainedRays, OfABarInAGrooveBeginAtTheTangentOfItsHalfAngle) {
  const double angle = 20 * std::acos(-1.0) / 180;
  problems::Structure bar;
  bar.dimension = 2;
  bar.units = {"m", "kN"};
  bar.node_names = {"a", "b"};
  bar.coordinates = Eigen::MatrixXd{{-1, 1}, {0, 0}};
  bar.fixed.resize(2);
  bar.members.push_back({0, 1, 1, {}});
  bar.contact.push_back({0, Eigen::Vector2d(std::cos(angle), std::sin(angle)), std::nullopt, 1});
  bar.contact.push_back({1, Eigen::Vector2d(-std::cos(angle), std::sin(angle)), std::nullopt, 1});
  for (const auto method : {RayMethod::double_description, RayMethod::tree}) {
    EXPECT_TRUE(rays_of(bar, std::tan(angle) * (1 - 1e-6), method).rays.empty());
    const auto above = rays_of(bar, std::tan(angle) * (1 + 1e-6), method);
    ASSERT_EQ(above.cones.size(), 1U);
    EXPECT_EQ(above.cones.front().reaction, 0b11U);
    EXPECT_FALSE(above.rays.empty());
    EXPECT_FALSE(above.motions.empty());
  }
}

// The two methods, each with the count of wedged patterns at 2 of WheelOnAPinWedgesFromOne...
TEST(UnconstrainedRays, OfAWheelOnAPinDoNotDependOnTheDirectionOfTheAxes) {
  for (const double turn : {0.0, 0.1, 0.7, 1.234}) {
    for (const auto method : {RayMethod::double_description, RayMethod::tree}) {
      SCOPED_TRACE(turn);
      EXPECT_TRUE(rays_of(testing::wheel(3, turn), 0.5, method).rays.empty());
      EXPECT_EQ(rays_of(testing::wheel(3, turn), 2, method).cones.size(), 3U);
    }
  }
}

}  // namespace
}  // namespace kusabi::wedged
