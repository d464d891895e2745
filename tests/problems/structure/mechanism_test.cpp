// Mechanisms are found and named; slender, stiff, soft and mixed stable trusses are accepted.
#include "problems/structure/bodies/mechanism.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

std::vector<int> moving(const Structure& structure) {
  return moving_nodes(structure, free_degrees(structure));
}

class StableCantilever : public testing::TestWithParam<int> {};

TEST_P(StableCantilever, IsNotAMechanism) {
  EXPECT_THAT(moving(test::cantilever(GetParam())), testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Bays, StableCantilever, testing::Values(1, 3, 30, 300, 1000));

TEST(Mechanism, OfABayWithoutADiagonalMovesEveryNodeBeyondIt) {
  // The parallelogram shears: nodes on its far side move up, those before it do not move.
  EXPECT_THAT(moving(test::cantilever(5, 2)), testing::ElementsAre(6, 7, 8, 9, 10, 11));
  EXPECT_THAT(moving(test::cantilever(30, 29)), testing::ElementsAre(60, 61));
}

TEST(Mechanism, NamesTheNodesOfAllIndependentMotions) {
  Structure structure = test::cantilever(3);
  const int first = test::add_node(structure, Eigen::Vector2d(0, 2));  // hangs on one bar
  const int second = test::add_node(structure, Eigen::Vector2d(3, 2));
  structure.members.push_back({1, first, 1.0});
  structure.members.push_back({7, second, 1.0});
  EXPECT_THAT(moving(structure), testing::ElementsAre(first, second));
}

TEST(Mechanism, OfAnUnsupportedTrussMovesEveryNode) {
  std::mt19937 bits(2);
  EXPECT_THAT(moving(test::random_cluster(3, 6, bits)), testing::ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(Mechanism, OfThreeNodesOnALineMovesTheMiddleOne) {
  Structure structure = test::two_bars();
  structure.coordinates.col(1) = Eigen::Vector2d(2, 0);
  EXPECT_THAT(moving(structure), testing::ElementsAre(2));
}

TEST(Mechanism, IsFoundInCoordinatesTypedWithEightDigits) {
  // Three nodes on a line of slope 1/3: rounding alone must not stabilise the middle one.
  Structure structure = test::two_bars();
  structure.coordinates.col(1) = Eigen::Vector2d(20.0, 6.6666667);
  structure.coordinates.col(2) = Eigen::Vector2d(10.0, 3.3333333);
  EXPECT_THAT(moving(structure), testing::ElementsAre(2));
}

TEST(Mechanism, IsDistinguishedFromTheSoftBendingOfASlenderTruss) {
  EXPECT_THAT(moving(test::cantilever(300, 299)), testing::ElementsAre(600, 601));
}

TEST(Mechanism, DoesNotDependOnTheSizeOfAnyAxialStiffness) {
  for (const double axial_stiffness : {1e-40, 1e-6, 1e9, 1e40}) {
    Structure stable = test::cantilever(30);
    Structure unstable = test::cantilever(30, 29);
    for (Structure* structure : {&stable, &unstable}) {
      for (std::size_t index = 0; index < structure->members.size(); index += 2) {
        structure->members[index].axial_stiffness = axial_stiffness;
      }
    }
    EXPECT_THAT(moving(stable), testing::IsEmpty());
    EXPECT_THAT(moving(unstable), testing::ElementsAre(60, 61));
  }
}

TEST(Mechanism, DoesNotDependOnTheUnitOfLength) {
  for (const double unit : {1e-40, 1e-3, 1e40}) {
    Structure stable = test::cantilever(10);
    Structure unstable = test::cantilever(10, 9);
    stable.coordinates *= unit;
    unstable.coordinates *= unit;
    EXPECT_THAT(moving(stable), testing::IsEmpty());
    EXPECT_THAT(moving(unstable), testing::ElementsAre(20, 21));
  }
}

}  // namespace
}  // namespace kusabi::problems
