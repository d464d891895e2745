// Algebra of one second-order cone of fixed dimension D for an interior-point method,
//
//   Q_D = { x = (x_0, x_1) : x_0 >= ||x_1|| }:
//
// Jordan product, step to the boundary, Nesterov-Todd scaling. A friction cone with d - 1 tangents
// is Q_d (the wedged paper, equation (4), in scaled form). D is a template argument because the
// cones are small (2 or 3): every operation unrolls. Real is double, or Pack for four cones at
// once.
#pragma once

#include <array>

#include "solvers/conic/pack.hpp"

namespace kusabi::conic {

/// A point of R^D; the head is entry 0.
template <int D, class Real = double>
using ConePoint = std::array<Real, static_cast<std::size_t>(D)>;

/// x'y.
template <std::size_t D, class Real>
KUSABI_INLINE Real dot(const std::array<Real, D>& x, const std::array<Real, D>& y) {
  Real sum = x[0] * y[0];
  for (std::size_t i = 1; i < D; ++i) sum += x[i] * y[i];
  return sum;
}

/// x_1'y_1.
template <std::size_t D, class Real>
KUSABI_INLINE Real tail_dot(const std::array<Real, D>& x, const std::array<Real, D>& y) {
  Real sum = x[1] * y[1];
  for (std::size_t i = 2; i < D; ++i) sum += x[i] * y[i];
  return sum;
}

/// ||x_1||.
template <std::size_t D, class Real>
KUSABI_INLINE Real radius(const std::array<Real, D>& x) {
  return root(tail_dot(x, x));
}

/// Distance measure x_0 - ||x_1||: positive exactly in the interior of Q_D.
template <std::size_t D, class Real>
KUSABI_INLINE Real margin(const std::array<Real, D>& x) {
  return x[0] - radius(x);
}

/// x_0^2 - ||x_1||^2, as a product of two factors, since the difference of squares would cancel
/// near the boundary. Positive with x_0 > 0 exactly in the interior of the cone.
template <std::size_t D, class Real>
KUSABI_INLINE Real determinant(const std::array<Real, D>& x) {
  const Real around = radius(x);
  return (x[0] - around) * (x[0] + around);
}

/// The Jordan product x o y = (x'y, x_0 y_1 + y_0 x_1). Its identity is e = (1, 0).
template <std::size_t D, class Real>
KUSABI_INLINE std::array<Real, D> jordan_product(const std::array<Real, D>& x,
                                                 const std::array<Real, D>& y) {
  std::array<Real, D> product;
  product[0] = dot(x, y);
  for (std::size_t i = 1; i < D; ++i) product[i] = x[0] * y[i] + y[0] * x[i];
  return product;
}

/// Nesterov-Todd scaling of an interior pair (x, z): the symmetric W with W z = W^-1 x = lambda.
/// With x and z divided by the roots of their determinants, J z = (z_0, -z_1) and gamma = sqrt((1 +
/// x'z) / 2), the scaling point is w = (x + J z) / (2 gamma), and W = eta V(w) where eta = (det x /
/// det z)^(1/4) and V(w) = [w_0, w_1'; w_1, I + w_1 w_1' / (1 + w_0)].
template <int D, class Real = double>
class NesterovToddScaling {
  static constexpr std::size_t size = D;

 public:
  using Vector = ConePoint<D, Real>;

  NesterovToddScaling() = default;

  /// @pre both points are in the interior of the cone
  KUSABI_INLINE NesterovToddScaling(const Vector& x, const Vector& z) {
    const Real root_x = root(determinant(x));
    const Real root_z = root(determinant(z));
    const Real inverse_x = 1.0 / root_x;
    const Real inverse_z = 1.0 / root_z;
    Vector x_unit, z_unit;
    for (std::size_t i = 0; i < size; ++i) {
      x_unit[i] = x[i] * inverse_x;
      z_unit[i] = z[i] * inverse_z;
    }
    const Real gamma = root((1.0 + dot(x_unit, z_unit)) * 0.5);
    const Real eta = root(root_x * inverse_z);
    const Real normaliser = 0.5 / gamma;
    const Real w_head = (x_unit[0] + z_unit[0]) * normaliser;
    const Real tail_share = eta / (1.0 + w_head);
    std::array<Real, size> w;
    for (std::size_t i = 1; i < size; ++i) w[i] = (x_unit[i] - z_unit[i]) * normaliser;
    matrix_[0][0] = eta * w_head;
    for (std::size_t i = 1; i < size; ++i) {
      matrix_[i][0] = matrix_[0][i] = eta * w[i];
      for (std::size_t j = 1; j <= i; ++j) matrix_[i][j] = matrix_[j][i] = tail_share * w[i] * w[j];
      matrix_[i][i] += eta;
    }

    // lambda in closed form, since W z would cancel near the boundary.
    lambda_root_ = root_z * eta;
    inverse_lambda_root_ = 1.0 / lambda_root_;
    lambda_unit_[0] = gamma;
    const Real share = 1.0 / (x_unit[0] + z_unit[0] + 2.0 * gamma);
    for (std::size_t i = 1; i < size; ++i)
      lambda_unit_[i] = ((gamma + z_unit[0]) * x_unit[i] + (gamma + x_unit[0]) * z_unit[i]) * share;
    inverse_head_ = 2.0 * normaliser;
    inverse_shift_ = 1.0 / (1.0 + gamma);
  }

  /// W_ij; W is symmetric positive definite.
  KUSABI_INLINE Real entry(std::size_t i, std::size_t j) const { return matrix_[i][j]; }

  /// W p.
  KUSABI_INLINE Vector times(const Vector& p) const {
    Vector product;
    for (std::size_t i = 0; i < size; ++i) product[i] = dot(matrix_[i], p);
    return product;
  }

  /// The scaled point lambda = W z = W^-1 x.
  KUSABI_INLINE Vector lambda() const {
    Vector point;
    for (std::size_t i = 0; i < size; ++i) point[i] = lambda_root_ * lambda_unit_[i];
    return point;
  }

  /// The solution q of lambda o q = right_side.
  KUSABI_INLINE Vector jordan_divide(const Vector& right_side) const {
    const Real head = lambda_unit_[0] * right_side[0] - tail_dot(lambda_unit_, right_side);
    Vector quotient;
    quotient[0] = head * inverse_lambda_root_;
    const Real share = inverse_head_ * inverse_lambda_root_;
    for (std::size_t i = 1; i < size; ++i)
      quotient[i] = (right_side[i] - head * lambda_unit_[i]) * share;
    return quotient;
  }

  /// Reciprocal of the largest step length alpha with lambda + alpha direction in the cone; not
  /// positive if every length stays inside. The reciprocals of several cones combine by their
  /// maximum. The computation maps lambda to the identity e, where the reciprocal is ||d_1|| - d_0.
  KUSABI_INLINE Real inverse_step_length(const Vector& direction) const {
    const Real head = lambda_unit_[0] * direction[0] - tail_dot(lambda_unit_, direction);
    const Real share = (head + direction[0]) * inverse_shift_;
    Vector turned;
    turned[0] = head;
    for (std::size_t i = 1; i < size; ++i) turned[i] = direction[i] - share * lambda_unit_[i];
    return -margin(turned) * inverse_lambda_root_;
  }

 private:
  std::array<Vector, size> matrix_;  // W
  Vector lambda_unit_;               // lambda / sqrt(det lambda)
  Real lambda_root_;                 // sqrt(det lambda)
  Real inverse_lambda_root_;
  Real inverse_head_;   // 1 / lambda_unit_[0]
  Real inverse_shift_;  // 1 / (lambda_unit_[0] + 1)
};

}  // namespace kusabi::conic
