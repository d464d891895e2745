// The algebra of one second-order cone of fixed dimension D,
//
//   Q_D = { x = (x_0, x_1) : x_0 >= ||x_1|| },
//
// that an interior-point method needs: Jordan product, step to the boundary, Nesterov-Todd scaling.
// A friction cone with d - 1 tangents is Q_d (the wedged paper, equation (4), in scaled form).
// D is a template argument because the cones are tiny (2 or 3): every operation unrolls.
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace kusabi::conic {

/// A point of R^D; the head is entry 0.
template <int D>
using Point = Eigen::Matrix<double, D, 1>;

/// x_0^2 - ||x_1||^2, as a product of two factors because the difference of squares would lose
/// its digits near the boundary. Positive with x_0 > 0 exactly when x is inside the cone.
template <int D>
double determinant(const Point<D>& x) {
  const double radius = x.template tail<D - 1>().norm();
  return (x[0] - radius) * (x[0] + radius);
}

/// Whether x lies in the interior of Q_D. False for a point that is not a number.
template <int D>
bool inside(const Point<D>& x) {
  return x[0] > x.template tail<D - 1>().norm();
}

/// The Jordan product x o y = (x'y, x_0 y_1 + y_0 x_1). Its identity is e = (1, 0).
template <int D>
Point<D> jordan_product(const Point<D>& x, const Point<D>& y) {
  Point<D> product;
  product[0] = x.dot(y);
  product.template tail<D - 1>() =
      x[0] * y.template tail<D - 1>() + y[0] * x.template tail<D - 1>();
  return product;
}

/// The Nesterov-Todd scaling of an interior pair (x, z): the symmetric W with
/// W z = W^-1 x = lambda, and what the iteration does in the scaled space.
/// With the determinants taken out, w = (x + J z) / |x + J z| and W = sqrt(det x / det z)^(1/2)
/// V(w) where V(w) = [w_0, w_1'; w_1, I + w_1 w_1' / (1 + w_0)].
template <int D>
class Scaling {
 public:
  Scaling() = default;

  /// Both points must be inside the cone.
  Scaling(const Point<D>& x, const Point<D>& z) {
    const double root_x = std::sqrt(determinant<D>(x));
    const double root_z = std::sqrt(determinant<D>(z));
    const Point<D> x_unit = x * (1 / root_x);
    const Point<D> z_unit = z * (1 / root_z);
    const auto x_tail = x_unit.template tail<D - 1>();
    const auto z_tail = z_unit.template tail<D - 1>();
    const double half = std::sqrt((1 + x_unit.dot(z_unit)) / 2);

    const double w_head = (x_unit[0] + z_unit[0]) / (2 * half);
    const double size = std::sqrt(root_x / root_z);
    const Eigen::Matrix<double, D - 1, 1> w_tail = (x_tail - z_tail) * (1 / (2 * half));
    const Eigen::Matrix<double, D - 1, 1> scaled_tail = size * w_tail;
    matrix_(0, 0) = size * w_head;
    matrix_.template bottomLeftCorner<D - 1, 1>() = scaled_tail;
    matrix_.template topRightCorner<1, D - 1>() = scaled_tail.transpose();
    matrix_.template bottomRightCorner<D - 1, D - 1>().noalias() =
        (scaled_tail * (1 / (1 + w_head))) * w_tail.transpose();
    matrix_.template bottomRightCorner<D - 1, D - 1>().diagonal().array() += size;

    // lambda in closed form: W z would cancel near the boundary.
    root_ = root_z * size;
    inverse_root_ = 1 / root_;
    unit_[0] = half;
    unit_.template tail<D - 1>() = ((half + z_unit[0]) * x_tail + (half + x_unit[0]) * z_tail) *
                                   (1 / (x_unit[0] + z_unit[0] + 2 * half));
    inverse_shift_ = 1 / (1 + half);
  }

  /// W, D x D, symmetric positive definite.
  const Eigen::Matrix<double, D, D>& matrix() const { return matrix_; }

  /// The scaled point lambda = W z = W^-1 x.
  Point<D> point() const { return root_ * unit_; }

  /// The solution q of lambda o q = right_side.
  Point<D> jordan_divide(const Point<D>& right_side) const {
    const auto unit_tail = unit_.template tail<D - 1>();
    Point<D> quotient;
    quotient[0] = unit_[0] * right_side[0] - unit_tail.dot(right_side.template tail<D - 1>());
    quotient.template tail<D - 1>() =
        (right_side.template tail<D - 1>() - quotient[0] * unit_tail) / unit_[0];
    return quotient * inverse_root_;
  }

  /// The reciprocal of the largest step a with lambda + a direction in the cone; not positive when
  /// no step leaves it. The reciprocals of several cones combine by their maximum.
  /// Turns lambda into the identity e first, where the reciprocal is ||d_1|| - d_0.
  double inverse_step(const Point<D>& direction) const {
    const auto unit_tail = unit_.template tail<D - 1>();
    const auto tail = direction.template tail<D - 1>();
    const double head = unit_[0] * direction[0] - unit_tail.dot(tail);
    const double radius = (tail - (head + direction[0]) * inverse_shift_ * unit_tail).norm();
    return (radius - head) * inverse_root_;
  }

 private:
  Eigen::Matrix<double, D, D> matrix_;  // W
  Point<D> unit_;                       // lambda / sqrt(det lambda)
  double root_ = 0;                     // sqrt(det lambda)
  double inverse_root_ = 0;
  double inverse_shift_ = 0;  // 1 / (unit_[0] + 1)
};

}  // namespace kusabi::conic
