// Column of T: the load of a parameter zeta_j in f_D + sum_j zeta_j t_j (section 3.1 of the limit
// paper), and the half-width of the parameter.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace kusabi::problems {

/// t_j = weight * direction, exactly: for a single component the weight is its absolute value and
/// the direction +1 or -1; otherwise the weight is 1. (In a LimitModel the largest component of the
/// direction is of size 1.)
struct UncertainColumn {
  struct Component {
    int degree;    ///< free displacement
    double value;  ///< not zero
  };

  double weight = 1;                 ///< w_j > 0
  std::vector<Component> direction;  ///< d_j, by displacement, not empty
  std::string name{};                ///< empty: a single component
  std::string group{};               ///< group with a common half-width
  /// h_j: |zeta_j| <= h_j alpha. A requested alpha applies to all columns, with h_j = 1; if some
  /// have a half-width of their own, each has h_j and alpha is 1.
  double half_width = 1;
  bool in_file = false;  ///< true if the file specifies its half-width

  /// A load at one free displacement. @param value not zero
  static UncertainColumn single(int degree, double value);

  /// d_j^T u. @param motion n^d
  [[nodiscard]] double along(const Eigen::VectorXd& motion) const;
  /// h_j w_j, the column's coefficient in the search.
  [[nodiscard]] double reach() const { return half_width * weight; }
  /// Adds h_j t_j times a share of alpha.
  void add_to(Eigen::VectorXd& load, double share) const;
  /// The absolute value of the largest component of h_j t_j.
  [[nodiscard]] double largest() const;
};

}  // namespace kusabi::problems
