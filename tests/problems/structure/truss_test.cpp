// The stiffness of a truss: hand calculations and rigid-body motions.
#include "problems/structure/model/truss.hpp"

#include <gtest/gtest.h>

#include "dense.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

/// A few roundings of numbers of the order of one.
constexpr double rounding = 1e-13;

Eigen::MatrixXd dense_stiffness(const Structure& structure) {
  const FreeDegrees degrees = free_degrees(structure);
  return truss_stiffness(structure, degrees, member_stiffnesses(structure));
}

TEST(Truss, StiffnessOfOneInclinedBarIsTheProductOfItsDirection) {
  Structure structure = test::empty_structure(2);
  test::add_node(structure, Eigen::Vector2d(1, 1));
  test::add_node(structure, Eigen::Vector2d(4, 5));  // direction (0.6, 0.8), length 5
  test::fix(structure, 0);
  structure.members = {{0, 1, 10.0}};  // EA / L = 2
  const Eigen::Matrix2d by_hand{{0.72, 0.96}, {0.96, 1.28}};
  EXPECT_TRUE(dense_stiffness(structure).isApprox(by_hand, rounding));
}

TEST(Truss, StiffnessOfABarBetweenFreeNodesHasOppositeOffDiagonalBlocks) {
  Structure structure = test::empty_structure(3);
  test::add_node(structure, Eigen::Vector3d(0, 0, 0));
  test::add_node(structure, Eigen::Vector3d(0, 0, 2));
  structure.members = {{1, 0, 6.0}};  // EA / L = 3, along z
  Eigen::MatrixXd by_hand = Eigen::MatrixXd::Zero(6, 6);
  by_hand(2, 2) = by_hand(5, 5) = 3.0;
  by_hand(2, 5) = by_hand(5, 2) = -3.0;
  EXPECT_TRUE(dense_stiffness(structure).isApprox(by_hand, rounding));
}

TEST(Truss, StiffnessOfTwoBarsIsTheirSum) {
  const Eigen::Matrix2d by_hand{{1.0, 0.0}, {0.0, 3.0}};
  EXPECT_TRUE(dense_stiffness(test::two_bars()).isApprox(by_hand, rounding));
}

TEST(Truss, FreeDegreesLeaveOutTheFixedAxesOnly) {
  Structure structure = test::two_bars();
  structure.fixed[0] = {false, true, false};  // a roller along x
  const FreeDegrees degrees = free_degrees(structure);
  ASSERT_EQ(degrees.size(), 3);
  const Eigen::MatrixXi by_hand{{0, -1, 1}, {-1, -1, 2}};
  EXPECT_EQ(degrees.number, by_hand);
  EXPECT_EQ(degrees.free[0].node, 0);
  EXPECT_EQ(degrees.free[2].node, 2);
  EXPECT_EQ(degrees.free[2].axis, 1);
}

TEST(Truss, StiffnessIsSymmetricToTheLastBit) {
  std::mt19937 bits(3);
  const Eigen::MatrixXd stiffness = dense_stiffness(test::random_wedge(3, 12, bits));
  EXPECT_EQ(stiffness, Eigen::MatrixXd(stiffness.transpose()));
}

TEST(Truss, EnergyIsTheSumOverTheElongations) {
  std::mt19937 bits(4);
  const Structure structure = test::random_wedge(3, 8, bits);
  const FreeDegrees degrees = free_degrees(structure);
  const Eigen::VectorXd motion = test::random_vector(degrees.size(), bits);
  const Eigen::VectorXd stretched = elongations(structure, degrees, motion);
  const double from_matrix = motion.dot(dense_stiffness(structure) * motion);
  const double from_members = stretched.dot(member_stiffnesses(structure).cwiseProduct(stretched));
  EXPECT_NEAR(from_matrix, from_members, rounding * from_members);
}

class RigidBody : public testing::TestWithParam<int> {};

TEST_P(RigidBody, ModesAreTheOnlyMotionsOfATrussWithoutEnergy) {
  const int dimension = GetParam();
  std::mt19937 bits(5);
  const Structure structure = test::random_cluster(dimension, 7, bits);
  const Eigen::MatrixXd stiffness = dense_stiffness(structure);
  Eigen::MatrixXd rigid(stiffness.rows(), dimension * (dimension + 1) / 2);
  Eigen::Index column = 0;
  for (int axis = 0; axis < dimension; ++axis) {
    rigid.col(column++) = Eigen::VectorXd::Unit(dimension, axis).replicate(7, 1);
  }
  for (int from = 0; from < dimension; ++from) {
    for (int to = from + 1; to < dimension; ++to) {  // rotation in the plane of two axes
      Eigen::MatrixXd rotated = Eigen::MatrixXd::Zero(dimension, 7);
      rotated.row(from) = -structure.coordinates.row(to);
      rotated.row(to) = structure.coordinates.row(from);
      rigid.col(column++) = rotated.reshaped();
    }
  }
  EXPECT_LT((stiffness * rigid).cwiseAbs().maxCoeff(), rounding * stiffness.maxCoeff());
  EXPECT_EQ(dense::rank(stiffness), stiffness.rows() - rigid.cols());
}

INSTANTIATE_TEST_SUITE_P(PlaneAndSpace, RigidBody, testing::Values(2, 3));

}  // namespace
}  // namespace kusabi::problems
