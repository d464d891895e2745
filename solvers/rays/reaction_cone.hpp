// The cone C_r of the paper's section 4.2 in the coordinates p, q, and the numbers of its rays.
//
// The normal displacements are u_n = A x with x = (p_1, q_1, ..., p_m, q_m):
//
//   A_{i, p_k} = F_{n_i n_k} / (2 mu_k) - F_{n_i t_k} / 2,
//   A_{i, q_k} = F_{n_i n_k} / (2 mu_k) + F_{n_i t_k} / 2,
//
// and C_r = {x >= 0, A x >= 0}. Without friction there is one generator instead of two: p_k is then
// r_nk itself, and q_k is zero. Bodies that nothing holds add motions alpha of any sign, u_n = A x
// + H alpha, and equations of equilibrium E x = 0. It needs Eigen only, like solvers/conic.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "solvers/rays/health.hpp"
#include "solvers/rays/loose_motions.hpp"
#include "solvers/rays/null_vector.hpp"
#include "solvers/rays/zero_set.hpp"

namespace kusabi::rays {

/// The numbers of one ray.
struct Ray {
  Eigen::VectorXd reaction;  ///< r, 2m, force: (n, t) of each candidate; the normal ones sum to 1
  Eigen::VectorXd displacement;  ///< u = F r + G alpha, 2m, length
};

class ReactionCone {
 public:
  /// @param compliance F, 2m x 2m, symmetric positive definite, ordered by candidate and in it (n,
  /// t)
  /// @param friction mu, m numbers >= 0, 1 <= m <= 64
  /// @param motions G of bodies that nothing holds, 2m x p, of rank p; none: all are held
  /// @throws std::invalid_argument if the sizes disagree or a number is out of range
  ReactionCone(const PreciseMatrix& compliance, std::span<const double> friction,
               const PreciseMatrix& motions = {});

  int candidates() const { return static_cast<int>(friction_.size()); }
  Candidates all() const { return first_candidates(candidates()); }

  bool slips(int candidate) const { return friction_[static_cast<std::size_t>(candidate)] == 0; }

  /// Unknowns: p and q of all candidates, and behind them motions that lift some.
  Eigen::Index unknowns() const { return gaps_.cols(); }
  /// Equations of equilibrium.
  int equations() const { return static_cast<int>(gaps_.rows()) - candidates(); }
  /// A candidate for each motion that lifts, which the later ones leave alone.
  const std::vector<int>& pivots() const { return motions_.pivots; }

  /// (A H), m rows, and below it (E 0); column 2 k is p_k, column 2 k + 1 is q_k.
  const PreciseMatrix& gaps() const { return gaps_; }

  /// The unknowns of the ray with this zero set, the null vector of its equalities: x has the sum
  /// 1, or, of a motion alone, the largest number is 1 in size.
  PreciseVector coordinates(const ZeroSet& zero) const { return coordinates(zero, whole()); }

  /// What a cone is cut by while it is made.
  struct Stage {
    Candidates gaps = 0;      ///< u_n >= 0 there
    Candidates balanced = 0;  ///< equations of equilibrium, as bits
  };

  /// The same of a ray of such a cone, to the digits of a double, in a fraction of the time.
  Eigen::VectorXd rounded_coordinates(const ZeroSet& zero, const Stage& stage) const;

  /// The ray with this zero set, made of its `coordinates`. All methods call this, so that equal
  /// zero sets give equal bits. `health` is told the largest displacement that should vanish and
  /// the smallest that should not; a ray whose numbers contradict its zero set counts as doubtful.
  /// Of a motion alone the reaction is zero, and the largest displacement 1.
  Ray ray(const ZeroSet& zero, Health& health) const;

 private:
  Stage whole() const { return {all(), first_candidates(equations())}; }
  PreciseVector coordinates(const ZeroSet& zero, const Stage& stage) const;

  PreciseMatrix compliance_;
  LooseMotions motions_;
  long double unit_ = 1;  // of the numbers of motions
  PreciseMatrix gaps_;
  PreciseMatrix scaled_gaps_;     // the rows of A divided by their largest entries
  Eigen::MatrixXd rounded_gaps_;  // the same in doubles
  std::vector<double> friction_;
};

}  // namespace kusabi::rays
