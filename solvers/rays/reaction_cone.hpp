// ReactionCone: the cone C_r of section 4.2 of the wedged paper in the coordinates p, q, and the
// coordinates of its rays.
//
// The normal displacements are u_n = A x with x = (p_1, q_1, ..., p_m, q_m):
//
//   A_{i, p_k} = F_{n_i n_k} / (2 mu_k) - F_{n_i t_k} / 2,
//   A_{i, q_k} = F_{n_i n_k} / (2 mu_k) + F_{n_i t_k} / 2,
//
// and C_r = {x >= 0, A x >= 0}. Without friction there is one generator instead of two: p_k is then
// r_nk itself, and q_k is zero. Unconstrained bodies add rigid-body modes alpha of any sign, u_n =
// A x + H alpha, and equations of equilibrium E x = 0.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "solvers/rays/health.hpp"
#include "solvers/rays/null_vector.hpp"
#include "solvers/rays/pivoted_modes.hpp"
#include "solvers/rays/zero_set.hpp"

namespace kusabi::rays {

/// Coordinates of one ray.
struct Ray {
  Eigen::VectorXd reaction;  ///< r, 2m, force: (n, t) of each candidate; the normal ones sum to 1
  Eigen::VectorXd displacement;  ///< u = F r + G alpha, 2m, length
};

class ReactionCone {
 public:
  /// @param compliance F, 2m x 2m, symmetric positive definite, ordered by candidate and within it
  ///     (n, t)
  /// @param friction mu, m numbers >= 0, 1 <= m <= 64
  /// @param motions rigid-body modes G of unconstrained bodies, 2m x p, of rank p; may be empty
  /// @throws std::invalid_argument if the sizes disagree or a number is out of range
  ReactionCone(const LongMatrix& compliance, std::span<const double> friction,
               const LongMatrix& motions = {});

  int candidates() const { return static_cast<int>(friction_.size()); }
  Candidates all() const { return first_candidates(candidates()); }

  bool slips(int candidate) const { return friction_[static_cast<std::size_t>(candidate)] == 0; }

  /// Number of unknowns: p and q of all candidates, then modes with a normal part.
  Eigen::Index unknowns() const { return gaps_.cols(); }
  /// Number of equations of equilibrium.
  int equations() const { return static_cast<int>(gaps_.rows()) - candidates(); }
  /// A candidate for each mode with a normal part, which later modes do not displace.
  const std::vector<int>& pivots() const { return motions_.pivots; }

  /// (A H), m rows, and below it (E 0); column 2 k is p_k, column 2 k + 1 is q_k.
  const LongMatrix& gaps() const { return gaps_; }

  /// Unknowns of the ray with this zero set, the null vector of its equalities: x has the sum 1,
  /// or, for a mode alone, the largest number has the magnitude 1.
  LongVector coordinates(const ZeroSet& zero) const { return coordinates(zero, whole()); }

  /// Unknowns p and q of reactions; those of modes are left out.
  /// @param reaction 2m, ordered as that of a Ray
  LongVector unknowns_of(const Eigen::VectorXd& reaction) const;

  /// Inequalities and equations by which a cone has been cut so far.
  struct Stage {
    Candidates gaps = 0;      ///< u_n >= 0 there
    Candidates balanced = 0;  ///< equations of equilibrium, as bits
  };

  /// Coordinates of a ray at a stage, to the digits of a double, in a fraction of the time.
  Eigen::VectorXd rounded_coordinates(const ZeroSet& zero, const Stage& stage) const;

  /// The ray with this zero set, from its `coordinates`. All methods use this function, so that
  /// equal zero sets give equal bits. `health` records the largest displacement that should vanish
  /// and the smallest that should not; a ray whose numbers contradict its zero set counts as
  /// numerically undecided. For a mode alone the reaction is zero, and the largest displacement is
  /// 1.
  Ray ray(const ZeroSet& zero, Health& health) const;

 private:
  Stage whole() const { return {all(), first_candidates(equations())}; }
  LongVector coordinates(const ZeroSet& zero, const Stage& stage) const;

  LongMatrix compliance_;
  PivotedModes motions_;
  long double unit_ = 1;  // unit of the modes
  LongMatrix gaps_;
  LongMatrix scaled_gaps_;        // rows of A divided by their largest entries
  Eigen::MatrixXd rounded_gaps_;  // scaled_gaps_ in doubles
  std::vector<double> friction_;
};

}  // namespace kusabi::rays
