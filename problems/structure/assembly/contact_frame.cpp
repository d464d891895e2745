// Contact frames by one Gram-Schmidt step.
#include "problems/structure/assembly/contact_frame.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

namespace kusabi::problems {
namespace {

template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// Component of `vector` orthogonal to the unit `normal`. The second pass removes the rounding
/// errors of the first.
template <class Scalar>
Vector<Scalar> across(const Vector<Scalar>& normal, const Vector<Scalar>& vector) {
  const Vector<Scalar> once = vector - normal.dot(vector) * normal;
  return once - normal.dot(once) * normal;
}

template <class Scalar>
Vector<Scalar> chosen_tangent(const Vector<Scalar>& normal) {
  using std::abs;
  if (normal.size() == 2) return Eigen::Matrix<Scalar, 2, 1>(normal(1), -normal(0));
  Eigen::Index farthest = 0;
  for (Eigen::Index axis = 1; axis < normal.size(); ++axis) {
    if (abs(normal(axis)) < abs(normal(farthest))) farthest = axis;
  }
  return Vector<Scalar>::Unit(normal.size(), farthest);
}

/// @param normal of unit length  @param given optional tangent of a length near one
template <class Scalar>
Matrix<Scalar> frame_of(const Vector<Scalar>& normal, const std::optional<Vector<Scalar>>& given) {
  const Vector<Scalar> tangent = across<Scalar>(normal, given ? *given : chosen_tangent(normal));
  Matrix<Scalar> frame(normal.size(), normal.size());
  frame.col(0) = normal;
  frame.col(1) = tangent / tangent.norm();
  if (normal.size() == 3) {
    using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
    frame.col(2) = Vector3(frame.col(0)).cross(Vector3(frame.col(1)));
  }
  return frame;
}

}  // namespace

double tangent_sine(const Eigen::VectorXd& normal, const Eigen::VectorXd& tangent) {
  if (tangent.isZero(0.0)) return std::numeric_limits<double>::quiet_NaN();
  return across<double>(normal, tangent.stableNormalized()).norm();
}

Eigen::MatrixXd contact_frame(const ContactCandidate& candidate) {
  std::optional<Eigen::VectorXd> given;
  if (candidate.tangent) given = candidate.tangent->stableNormalized();
  return frame_of<double>(candidate.normal, given);
}

numbers::PreciseMatrix precise_contact_frame(const ContactCandidate& candidate) {
  using numbers::Precise;
  using numbers::PreciseVector;
  const PreciseVector direction = candidate.direction.value_or(candidate.normal).cast<Precise>();
  const PreciseVector normal = direction / direction.norm();
  std::optional<PreciseVector> given;
  if (candidate.tangent) {
    // Division by a power of two is exact.
    const double size = std::exp2(-std::round(std::log2(candidate.tangent->stableNorm())));
    const PreciseVector scaled = (*candidate.tangent * size).cast<Precise>();
    given = scaled;
  }
  return frame_of<Precise>(normal, given);
}

}  // namespace kusabi::problems
