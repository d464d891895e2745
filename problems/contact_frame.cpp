// Contact frames by one Gram-Schmidt step.
#include "problems/contact_frame.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace kusabi::problems {
namespace {

/// Component of `vector` across the unit `normal`. Twice is enough: the second pass removes what
/// rounding left along the normal.
Eigen::VectorXd across(const Eigen::VectorXd& normal, const Eigen::VectorXd& vector) {
  const Eigen::VectorXd once = vector - normal.dot(vector) * normal;
  return once - normal.dot(once) * normal;
}

Eigen::VectorXd chosen_tangent(const Eigen::VectorXd& normal) {
  if (normal.size() == 2) return Eigen::Vector2d(normal(1), -normal(0));
  Eigen::Index farthest = 0;
  for (Eigen::Index axis = 1; axis < normal.size(); ++axis) {
    if (std::abs(normal(axis)) < std::abs(normal(farthest))) farthest = axis;
  }
  return Eigen::VectorXd::Unit(normal.size(), farthest);
}

}  // namespace

double tangent_sine(const Eigen::VectorXd& normal, const Eigen::VectorXd& tangent) {
  if (tangent.isZero(0.0)) return std::numeric_limits<double>::quiet_NaN();
  return across(normal, tangent.stableNormalized()).norm();
}

Eigen::MatrixXd contact_frame(const ContactCandidate& candidate) {
  const Eigen::VectorXd& normal = candidate.normal;
  const Eigen::VectorXd wish =
      candidate.tangent ? candidate.tangent->stableNormalized() : chosen_tangent(normal);
  Eigen::MatrixXd frame(normal.size(), normal.size());
  frame.col(0) = normal;
  frame.col(1) = across(normal, wish).normalized();
  if (normal.size() == 3) {
    frame.col(2) = Eigen::Vector3d(frame.col(0)).cross(Eigen::Vector3d(frame.col(1)));
  }
  return frame;
}

}  // namespace kusabi::problems
