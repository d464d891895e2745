// Rigid-body modes that supports leave a body: by hand, at any place and in any unit.
#include "problems/structure/bodies/rigid_motions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/structure/bodies/grounding_springs.hpp"
#include "problems/structure/bodies/mechanism.hpp"
#include "support/input_error.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

/// A square with one diagonal, nodes 0 to 3 at (0, 0), (1, 0), (1, 1), (0, 1).
Structure square(double unit = 1, const Eigen::Vector2d& place = {0, 0}) {
  Structure structure = test::empty_structure(2);
  for (const auto& vertex :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 1), Eigen::Vector2d(0, 1)})
    test::add_node(structure, unit * (vertex + place));
  for (const auto& [first, second] :
       std::vector<std::pair<int, int>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}})
    structure.members.push_back({first, second, 1.0});
  return structure;
}

std::string motions(const Structure& structure) {
  const auto bodies = unconstrained_bodies(structure);
  return bodies.empty() ? "held" : described(bodies.front());
}

void hold(Structure& structure, int node, int axis) {
  structure.fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(axis)] = true;
}

TEST(RigidMotions, AreThoseThatSupportsDoNotPrevent) {
  Structure body = square();
  EXPECT_EQ(motions(body), "can move along x and y and turn");
  hold(body, 0, 1);
  EXPECT_EQ(motions(body), "can move along x and turn");
  hold(body, 1, 1);
  EXPECT_EQ(motions(body), "can move along x");
  hold(body, 3, 0);
  EXPECT_EQ(motions(body), "held");
  Structure pinned = square();
  test::fix(pinned, 2);
  EXPECT_EQ(motions(pinned), "can turn");
  const auto body_of_pin = unconstrained_bodies(pinned).front();
  EXPECT_TRUE(displacements(body_of_pin, pinned.coordinates.col(2)).cast<double>().isZero(0.0));
}

TEST(RigidMotions, OfTwoRollersAreARotationAboutTheirIntersection) {
  Structure body = square();
  hold(body, 0, 0);  // through (0, 0) horizontally
  hold(body, 3, 1);  // and through (0, 1) vertically: they meet in (0, 0)
  EXPECT_EQ(motions(body), "can turn");
  hold(body, 1, 0);  // on the line of the first
  EXPECT_EQ(motions(body), "can turn");
  hold(body, 2, 0);
  EXPECT_EQ(motions(body), "held");
}

TEST(RigidMotions, DoNotDependOnTheUnitNorOnThePlace) {
  for (const double unit : {1e-40, 1e-3, 1.0, 1e9, 1e40}) {
    for (const double far : {0.0, 1.0 / 3, 1e4}) {
      Structure body = square(unit, {far, -far});
      EXPECT_EQ(motions(body), "can move along x and y and turn");
      hold(body, 0, 1);
      hold(body, 1, 1);
      EXPECT_EQ(motions(body), "can move along x");
      const auto bodies = unconstrained_bodies(body);
      const auto held = grounded_structure(body, free_degrees(body), bodies);
      EXPECT_THAT(moving_nodes(held, free_degrees(held)), testing::IsEmpty());
    }
  }
}

TEST(RigidMotions, OfASpringAreThoseOfASupport) {
  Structure body = square();
  body.springs = {{0, 1, 1e-3}, {1, 1, 1e3}};
  EXPECT_EQ(motions(body), "can move along x");
}

TEST(RigidMotions, InSpaceIncludeTheRotationAboutTwoHinges) {
  std::mt19937 bits(4);
  Structure cluster = test::random_cluster(3, 6, bits);
  EXPECT_EQ(motions(cluster), "can move along x, y and z and turn about x, y and z");
  cluster.coordinates.col(0) = Eigen::Vector3d(0, 0, 0);
  cluster.coordinates.col(1) = Eigen::Vector3d(3, 4, 0);
  test::fix(cluster, 0);
  EXPECT_EQ(motions(cluster), "can turn about x, y and z");
  test::fix(cluster, 1);
  EXPECT_EQ(motions(cluster), "can turn about (0.6, 0.8, 0)");
  EXPECT_EQ(unconstrained_bodies(cluster).front().nodes, (std::vector<int>{2, 3, 4, 5}));
}

TEST(RigidMotions, OfABarInSpaceAreFive) {
  Structure bar = test::empty_structure(3);
  test::add_node(bar, Eigen::Vector3d(0, 0, 0));
  test::add_node(bar, Eigen::Vector3d(0, 0, 2));
  bar.members.push_back({0, 1, 1.0});
  EXPECT_EQ(motions(bar), "can move along x, y and z and turn about x and y");
}

TEST(RigidMotions, ConstrainedStructuresAndMechanismsHaveNone) {
  EXPECT_EQ(motions(test::cantilever(4)), "held");
  EXPECT_EQ(motions(test::cantilever(4, 2)), "held");  // a mechanism, but not of a rigid body
}

TEST(RigidMotions, OfPiecesConnectedBySupportsOnlyAreSeparate) {
  Structure body = square();
  test::fix(body, 0);
  const int tip = test::add_node(body, Eigen::Vector2d(-1, 0));
  body.members.push_back({0, tip, 1.0});
  ASSERT_EQ(unconstrained_bodies(body).size(), 2U);
  EXPECT_EQ(unconstrained_bodies(body).back().nodes, std::vector<int>{tip});
}

}  // namespace
}  // namespace kusabi::problems
