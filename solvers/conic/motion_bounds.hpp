// What it takes to mend the equations that the motions of a loose body add to a node program, so
// that its bounds hold in spite of rounding (docs/theory/wedged.md, "Loose bodies").
//
// From below, a reaction must be in equilibrium, G'r = 0, and u_n = F_n r + H alpha = 0 on U, H the
// normal rows of G. From above, normal forces y must be in equilibrium, H'y = 0: a motion may be of
// any size, so nothing else keeps it from changing y'u_n.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace kusabi::conic {

/// Bounds for one G, in doubles; sizes of F are given by R_i = sqrt(F_ii).
class MotionBounds {
 public:
  MotionBounds() = default;

  /// @param motions G, D rows a cone  @param lifting how many columns have normal parts
  /// @param roots R of all rows of F  @param first_rows row (n, i) of each candidate
  MotionBounds(Eigen::MatrixXd motions, int lifting, double error, Eigen::VectorXd roots,
               std::vector<Eigen::Index> first_rows);

  [[nodiscard]] bool any() const { return motions_.cols() > 0; }
  [[nodiscard]] int count() const { return static_cast<int>(motions_.cols()); }
  [[nodiscard]] double least_root() const { return least_root_; }

  /// By what an entry of G may be wrong.
  [[nodiscard]] double error() const { return error_; }

  /// By how much H a of motions `a`, and its like, may be wrong: times the sum of the sizes.
  [[nodiscard]] double noise(double rounding) const {
    return error_ + rounding * std::max(largest_, 1.0);
  }

  /// The size |R delta| of the reactions on the cones of C that carry a load of size 1 on the
  /// motions; infinite if there are none.
  /// @param cones C, D rows each
  [[nodiscard]] double carry(std::span<const int> cones, int dimension) const;

  /// The size of the motion that makes gaps of size 1 (over R) on the candidates of U, if some
  /// does.
  [[nodiscard]] double close(std::span<const int> contact) const;

  /// |H_j|: by how much a motion of size 1 moves a candidate along its normal.
  [[nodiscard]] double lift(int candidate) const;

  /// The share of each y_j that brings normal forces into equilibrium, if all change by at most
  /// this share; more than 1 if they cannot.
  /// @param rows candidates with a force  @param sizes by how much each may change
  /// @param load H'y, what is to be balanced  @param noise what a component may be wrong by
  /// @param whole whether no force may be left out of what can be balanced
  [[nodiscard]] double balance(std::span<const int> rows, const std::vector<double>& sizes,
                               const Eigen::VectorXd& load, double noise, bool whole) const;

 private:
  Eigen::MatrixXd motions_;
  Eigen::VectorXd roots_;
  std::vector<Eigen::Index> first_rows_;
  int lifting_ = 0;
  double error_ = 0;
  double least_root_ = 0;
  double largest_ = 0;
};

}  // namespace kusabi::conic
