// Contact frames: orthonormal, right-handed in space, and along given tangents.
#include "problems/structure/assembly/contact_frame.hpp"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

/// A few roundings of numbers of the order of one.
constexpr double frame_rounding = 1e-14;

ContactCandidate candidate(const Eigen::VectorXd& normal,
                           std::optional<Eigen::VectorXd> tangent = std::nullopt) {
  return {0, normal.normalized(), std::move(tangent)};
}

void expect_orthonormal(const Eigen::MatrixXd& frame) {
  EXPECT_TRUE((frame.transpose() * frame).isIdentity(frame_rounding)) << frame;
}

TEST(ContactFrame, IsOrthonormalAndRightHandedInSpaceForAnyNormal) {
  std::mt19937 bits(1);
  for (int repeat = 0; repeat < 1000; ++repeat) {
    const ContactCandidate chosen = candidate(test::random_vector(3, bits));
    ContactCandidate with_tangent = chosen;
    with_tangent.tangent = test::random_vector(3, bits);
    for (const Eigen::MatrixXd& frame : {contact_frame(chosen), contact_frame(with_tangent)}) {
      expect_orthonormal(frame);
      EXPECT_EQ(Eigen::Vector3d(frame.col(0)), Eigen::Vector3d(chosen.normal));
      EXPECT_NEAR(Eigen::Matrix3d(frame).determinant(), 1.0, frame_rounding);
    }
  }
}

TEST(ContactFrame, OfAnAxisIsMadeOfAxes) {
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::MatrixXd frame = contact_frame(candidate(Eigen::Vector3d::Unit(axis)));
    EXPECT_EQ(frame.cwiseAbs().sum(), 3.0) << frame;
    expect_orthonormal(frame);
  }
}

TEST(ContactFrame, TangentInThePlaneIsTheNormalTurnedClockwise) {
  const Eigen::MatrixXd frame = contact_frame(candidate(Eigen::Vector2d(3, 4)));
  EXPECT_TRUE(frame.col(1).isApprox(Eigen::Vector2d(0.8, -0.6), frame_rounding));
}

TEST(ContactFrame, FollowsTheGivenTangentInThePlane) {
  const Eigen::VectorXd given = Eigen::Vector2d(-1, 5);
  const Eigen::MatrixXd frame = contact_frame(candidate(Eigen::Vector2d(3, 4), given));
  EXPECT_TRUE(frame.col(1).isApprox(Eigen::Vector2d(-0.8, 0.6), frame_rounding));
}

TEST(ContactFrame, FirstTangentIsTheGivenOneProjectedOntoTheSurface) {
  const Eigen::VectorXd given = Eigen::Vector3d(0, 1e-3, 7);  // almost along the normal
  const Eigen::MatrixXd frame = contact_frame(candidate(Eigen::Vector3d::UnitZ(), given));
  EXPECT_TRUE(frame.col(1).isApprox(Eigen::Vector3d::UnitY(), frame_rounding));
  EXPECT_TRUE(frame.col(2).isApprox(-Eigen::Vector3d::UnitX(), frame_rounding));
}

TEST(ContactFrame, DoesNotDependOnTheLengthOfTheGivenTangent) {
  for (const double length : {1e-40, 1.0, 1e40}) {
    const Eigen::VectorXd given = length * Eigen::Vector3d(1, 1, 0);
    const Eigen::MatrixXd frame = contact_frame(candidate(Eigen::Vector3d::UnitX(), given));
    EXPECT_TRUE(frame.col(1).isApprox(Eigen::Vector3d::UnitY(), frame_rounding)) << length;
  }
}

TEST(ContactFrame, TangentSineIsThatOfTheAngle) {
  const Eigen::VectorXd normal = Eigen::Vector2d::UnitX();
  EXPECT_NEAR(tangent_sine(normal, Eigen::Vector2d(4, 3)), 0.6, frame_rounding);
  EXPECT_NEAR(tangent_sine(normal, Eigen::Vector2d(-2, 0)), 0.0, frame_rounding);
  EXPECT_TRUE(std::isnan(tangent_sine(normal, Eigen::Vector2d(0, 0))));
}

}  // namespace
}  // namespace kusabi::problems
