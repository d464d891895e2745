// RigidModeBounds: bounds of the corrections to the equations that the rigid-body modes of an
// unconstrained body add to a node program, so that the bounds of t* include rounding errors
// (docs/theory/wedged.md, "Unconstrained bodies").
//
// For the lower bound a reaction must be in equilibrium, G'r = 0, and u_n = F_n r + H alpha = 0 on
// U, H the normal rows of G. For the upper bound the normal forces y must be in equilibrium, H'y =
// 0, since a rigid-body displacement of any size would change y'u_n.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace kusabi::conic {

/// Bounds for one G, in doubles; magnitudes of F are given by R_i = sqrt(F_ii).
class RigidModeBounds {
 public:
  RigidModeBounds() = default;

  /// @param motions G, D rows per cone  @param lifting number of columns with normal parts
  /// @param error of the entries of G
  /// @param roots R of all rows of F  @param first_rows row (n, i) of each candidate
  RigidModeBounds(Eigen::MatrixXd motions, int lifting, double error, Eigen::VectorXd roots,
                  std::vector<Eigen::Index> first_rows);

  [[nodiscard]] bool has_modes() const { return motions_.cols() > 0; }
  [[nodiscard]] int count() const { return static_cast<int>(motions_.cols()); }
  [[nodiscard]] double min_root() const { return min_root_; }

  /// Error bound of the entries of G.
  [[nodiscard]] double error() const { return error_; }

  /// Error bound of H a, and similar products, per unit of the sum of the magnitudes of `a`.
  [[nodiscard]] double noise(double rounding) const {
    return error_ + rounding * std::max(largest_, 1.0);
  }

  /// Magnitude |R delta| of the reactions on the cones of C that carry a load of magnitude 1 on the
  /// modes; zero if they carry none. Tangential reactions exist with friction only. Infinite if a
  /// load of `loads` acts on a mode on which no reaction does, up to the rounding of the file.
  /// @param cones C without the loads, D rows each  @param friction of each cone
  [[nodiscard]] double carrying_reaction(std::span<const int> cones, int dimension,
                                         std::span<const double> friction,
                                         std::span<const int> loads = {}) const;

  /// Magnitude of the rigid-body displacement that causes gaps of magnitude 1 (over R) on the
  /// candidates of U, if some mode does.
  [[nodiscard]] double closing_displacement(std::span<const int> contact) const;

  /// |H_j|: normal displacement of a candidate by a mode of magnitude 1.
  [[nodiscard]] double normal_displacement(int candidate) const;

  /// Relative change of each y_j that brings the normal forces into equilibrium, if all change by
  /// at most this share; more than 1 if that is impossible.
  /// @param rows candidates with a force  @param sizes largest change of each force
  /// @param load H'y, to be balanced  @param noise error of a component
  /// @param whole true if the result must cover all forces that can be balanced
  [[nodiscard]] double balance(std::span<const int> rows, const std::vector<double>& sizes,
                               const Eigen::VectorXd& load, double noise, bool whole) const;

 private:
  Eigen::MatrixXd motions_;
  Eigen::VectorXd roots_;
  std::vector<Eigen::Index> first_rows_;
  int lifting_ = 0;
  double error_ = 0;
  double min_root_ = 0;
  double largest_ = 0;
};

}  // namespace kusabi::conic
