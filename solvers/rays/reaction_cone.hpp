// The cone C_r of the paper's section 4.2 in the coordinates p, q, and the numbers of its rays.
//
// The normal displacements are u_n = A x with x = (p_1, q_1, ..., p_m, q_m):
//
//   A_{i, p_k} = F_{n_i n_k} / (2 mu_k) - F_{n_i t_k} / 2,
//   A_{i, q_k} = F_{n_i n_k} / (2 mu_k) + F_{n_i t_k} / 2,
//
// and C_r = {x >= 0, A x >= 0}. Without friction there is one generator instead of two: p_k is then
// r_nk itself, and q_k is zero. It needs Eigen only, like solvers/conic.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "solvers/rays/health.hpp"
#include "solvers/rays/null_vector.hpp"
#include "solvers/rays/zero_set.hpp"

namespace kusabi::rays {

/// The numbers of one ray.
struct Ray {
  Eigen::VectorXd reaction;  ///< r, 2m, force: (n, t) of each candidate; the normal ones sum to 1
  Eigen::VectorXd displacement;  ///< u = F r, 2m, length
};

class ReactionCone {
 public:
  /// @param compliance F, 2m x 2m, symmetric positive definite, ordered by candidate and in it (n,
  /// t)
  /// @param friction mu, m numbers >= 0, 1 <= m <= 64
  /// @throws std::invalid_argument if the sizes disagree or a number is out of range
  ReactionCone(const PreciseMatrix& compliance, std::span<const double> friction);

  int candidates() const { return static_cast<int>(friction_.size()); }
  Candidates all() const { return first_candidates(candidates()); }

  bool slips(int candidate) const { return friction_[static_cast<std::size_t>(candidate)] == 0; }

  /// A, m x 2m; column 2 k is p_k, column 2 k + 1 is q_k.
  const PreciseMatrix& gaps() const { return gaps_; }

  /// x of the ray with this zero set, 2m, with sum 1: the null vector of its equalities.
  PreciseVector coordinates(const ZeroSet& zero) const;

  /// The same to the digits of a double, in a fraction of the time.
  Eigen::VectorXd rounded_coordinates(const ZeroSet& zero) const;

  /// The ray with this zero set, made of its `coordinates`. All methods call this, so that equal
  /// zero sets give equal bits. `health` is told the largest displacement that should vanish and
  /// the smallest that should not; a ray whose numbers contradict its zero set counts as doubtful.
  Ray ray(const ZeroSet& zero, Health& health) const;

 private:
  PreciseMatrix compliance_;
  PreciseMatrix gaps_;
  PreciseMatrix scaled_gaps_;     // the rows of A divided by their largest entries
  Eigen::MatrixXd rounded_gaps_;  // the same in doubles
  std::vector<double> friction_;
};

}  // namespace kusabi::rays
