// A column of T: how a parameter zeta_j acts on the dead load, f_D + sum_j zeta_j t_j (section 3.1
// of the limit paper).
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace kusabi::problems {

/// t_j = weight * direction, exactly: of a single component the weight is its size and the
/// direction +1 or -1; otherwise the weight is 1. (In a LimitModel the largest component of the
/// direction is of size 1.)
struct UncertainColumn {
  struct Component {
    int degree;    ///< free displacement
    double value;  ///< not zero
  };

  double weight = 1;                 ///< w_j > 0
  std::vector<Component> direction;  ///< d_j, by displacement, not empty
  std::string name{};                ///< empty: of a single component

  /// The load at one free displacement. @param value not zero
  static UncertainColumn single(int degree, double value);

  /// d_j^T u. @param motion n^d
  [[nodiscard]] double along(const Eigen::VectorXd& motion) const;
  /// t_j^T u: the work of the load for zeta_j = 1.
  [[nodiscard]] double work(const Eigen::VectorXd& motion) const { return weight * along(motion); }
  /// Adds zeta t_j.
  void add_to(Eigen::VectorXd& load, double zeta) const;
  /// The size of the largest component of t_j.
  [[nodiscard]] double largest() const;
};

}  // namespace kusabi::problems
