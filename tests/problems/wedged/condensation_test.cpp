// Condensation, equation (3): against dense algebra and against the energy of the whole structure.
#include "problems/wedged/condensation.hpp"

#include <algorithm>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "problems/structure/truss.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

/// The random trusses have a condition of 1e4 at most: 1e-16 times that, and a margin.
constexpr double tolerance = 1e-10;

/// A random structure with the pieces that condensation takes.
struct Case {
  Structure structure;
  FreeDegrees degrees;
  Eigen::SparseMatrix<double> stiffness;
  std::vector<int> places;

  Case(int dimension, std::mt19937& bits) : structure(test::random_wedge(dimension, 10, bits)) {
    degrees = free_degrees(structure);
    stiffness = truss_stiffness(structure, degrees, member_stiffnesses(structure));
    for (const ContactCandidate& candidate : structure.contact) {
      for (int axis = 0; axis < dimension; ++axis) {
        places.push_back(degrees.number(axis, candidate.node));
      }
    }
    // Not sorted: condensation must keep the order it is given.
    std::swap(places.front(), places.back());
  }

  std::vector<int> others() const {
    std::vector<int> result;
    for (int number = 0; number < degrees.size(); ++number) {
      if (std::ranges::find(places, number) == places.end()) result.push_back(number);
    }
    return result;
  }
};

Eigen::MatrixXd identity(const Case& test_case) {
  const auto size = static_cast<Eigen::Index>(test_case.places.size());
  return Eigen::MatrixXd::Identity(size, size);
}

/// An orthogonal matrix without any structure.
Eigen::MatrixXd random_rotation(Eigen::Index size, std::mt19937& bits) {
  const Eigen::MatrixXd any = test::random_vector(size * size, bits).reshaped(size, size);
  return Eigen::HouseholderQR<Eigen::MatrixXd>(any).householderQ();
}

class Condensation : public testing::TestWithParam<int> {
 protected:
  std::mt19937 bits_{17};
};

TEST_P(Condensation, EqualsTheSchurComplementOfTheDenseStiffness) {
  const Case test_case(GetParam(), bits_);
  const Eigen::MatrixXd whole = test_case.stiffness;
  const std::vector<int> contact = test_case.places;
  const std::vector<int> rest = test_case.others();
  const Eigen::MatrixXd schur = whole(contact, contact) - whole(contact, rest) *
                                                              whole(rest, rest).inverse() *
                                                              whole(rest, contact);
  const auto condensed = condense(test_case.stiffness, contact, identity(test_case));
  ASSERT_TRUE(condensed);
  EXPECT_TRUE(condensed->stiffness.isApprox(schur, tolerance));
}

TEST_P(Condensation, ComplianceIsTheInverseOfTheStiffness) {
  const Case test_case(GetParam(), bits_);
  const auto condensed = condense(test_case.stiffness, test_case.places, identity(test_case));
  ASSERT_TRUE(condensed);
  EXPECT_TRUE(condensed->compliance.isApprox(condensed->stiffness.inverse(), tolerance));
}

TEST_P(Condensation, TurnsWithTheDirections) {
  const Case test_case(GetParam(), bits_);
  const Eigen::MatrixXd turned =
      random_rotation(static_cast<Eigen::Index>(test_case.places.size()), bits_);
  const auto along_axes = condense(test_case.stiffness, test_case.places, identity(test_case));
  const auto along_turned = condense(test_case.stiffness, test_case.places, turned);
  ASSERT_TRUE(along_axes && along_turned);
  EXPECT_TRUE((turned * along_turned->stiffness * turned.transpose())
                  .isApprox(along_axes->stiffness, tolerance));
  EXPECT_TRUE((turned * along_turned->compliance * turned.transpose())
                  .isApprox(along_axes->compliance, tolerance));
}

TEST_P(Condensation, EnergyOfTheContactNodesIsThatOfAllMembers) {
  const Case test_case(GetParam(), bits_);
  const auto condensed = condense(test_case.stiffness, test_case.places, identity(test_case));
  ASSERT_TRUE(condensed);
  const Eigen::VectorXd contact = test::random_vector(condensed->stiffness.rows(), bits_);
  // The rest follows without loads, equation (4).
  const Eigen::MatrixXd whole = test_case.stiffness;
  const std::vector<int> rest = test_case.others();
  Eigen::VectorXd displacement(whole.rows());
  displacement(test_case.places) = contact;
  displacement(rest) =
      -whole(rest, rest).ldlt().solve(Eigen::VectorXd(whole(rest, test_case.places) * contact));
  const Eigen::VectorXd stretched =
      elongations(test_case.structure, test_case.degrees, displacement);
  const double in_members =
      stretched.dot(member_stiffnesses(test_case.structure).cwiseProduct(stretched));
  EXPECT_NEAR(contact.dot(condensed->stiffness * contact), in_members, tolerance * in_members);
}

INSTANTIATE_TEST_SUITE_P(PlaneAndSpace, Condensation, testing::Values(2, 3));

TEST(CondensationOfAll, IsTheStiffnessItself) {
  const Structure structure = test::two_bars();
  const FreeDegrees degrees = free_degrees(structure);
  const auto stiffness = truss_stiffness(structure, degrees, member_stiffnesses(structure));
  const auto condensed = condense(stiffness, {0, 1}, Eigen::Matrix2d::Identity());
  ASSERT_TRUE(condensed);
  EXPECT_TRUE(condensed->stiffness.isApprox(Eigen::Matrix2d{{1, 0}, {0, 3}}, tolerance));
  EXPECT_TRUE(condensed->compliance.isApprox(Eigen::Matrix2d{{1, 0}, {0, 1.0 / 3}}, tolerance));
}

TEST(CondensationOfAnIndefiniteMatrix, IsRefused) {
  Eigen::SparseMatrix<double> matrix(2, 2);
  matrix.insert(0, 0) = 1.0;
  matrix.insert(1, 1) = -1.0;
  EXPECT_FALSE(condense(matrix, {0}, Eigen::MatrixXd::Identity(1, 1)));
}

}  // namespace
}  // namespace kusabi::problems
