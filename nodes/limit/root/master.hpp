// Relaxation tightened by static cuts, in the form of the limit paper's (23):
//
//   min  -sum_j alpha weight_j gamma_j - f_D'u + q^t'c+ + q^c'c-
//   s.t. f_R'u = 1,  B'u - c+ + c- = 0,  c+, c- >= 0,
//        0 <= gamma_j <= |y|'(c+ + c-) + |k|   for every cut (j, y, k),
//
// where gamma_j stands for |d_j'u|, column j of T being weight_j d_j. Where the sign s of d_j'u is
// decided, gamma_j is s d_j'u. d_j'u is a displacement, or has a variable and a row of its own.
//
// Its dual is a static statement, which proves the bound without the simplex method: forces q and a
// factor lambda in equilibrium with f_D, and shares mu_c >= 0 of the cuts, with
//
//   -q^c + s <= q <= q^t - s,   s = sum_c mu_c |y_c|,
//   sum of mu_c over the cuts of j = alpha weight_j.
//
// The bound is lambda - sum_c mu_c |k_c|.
#pragma once

#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "nodes/limit/model/static_cut.hpp"
#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/checked_simplex.hpp"

namespace kusabi::limit {

/// For each column of T the decided sign of d_j'u: -1 or 1; 0: undecided.
using Signs = std::vector<std::int8_t>;

/// A point of the relaxation.
struct Relaxed {
  Eigen::VectorXd motion;  ///< u
  Eigen::VectorXd z;       ///< c+ + c-
  Eigen::VectorXd gamma;   ///< m
};

/// The dual of the relaxation: the proof of its bound.
struct StaticProof {
  Signs signs;                ///< of its node
  double factor = 0;          ///< lambda
  Eigen::VectorXd forces;     ///< q
  std::vector<double> mu;     ///< a share of each cut
  Eigen::VectorXd one_sided;  ///< nu_j >= 0, m: multipliers of s d_j'u >= 0 for decided signs
};

class Master {
 public:
  /// @param stop ends a long solve()
  Master(const problems::LimitModel& model, double alpha, support::Stop stop = {});
  void set_stop(support::Stop stop) { stop_ = std::move(stop); }

  /// Reduces the yield forces by this, n^m; decide() removes the reduction.
  void reduce_yield_forces(const Eigen::VectorXd& reduction);

  /// After an optimal solve(): solves again with yield forces reduced by `first`, by ten times that
  /// and so on, until the proof holds for the actual ones with a margin for rounding. The bound
  /// decreases by about as much. Members whose force is determined by equilibrium (an idle cable)
  /// are not reduced.
  /// @param for_all those as well: they are identified by the size of motions, which may be wrong
  /// @return false if a solve fails
  bool solve_with_margin(double first, bool for_all = false);

  /// Adds q^y'(c+ + c-) <= maximum, which keeps the first points near relevant motions while there
  /// are too few cuts. Infinity: no limit. The optimum is a bound only if the limit is not active.
  void limit_dissipation(double maximum);
  /// True if some c+, c- or gamma is at the limit of its box: the cuts give no bound.
  [[nodiscard]] bool box_is_active() const;
  [[nodiscard]] bool dissipation_limit_is_active() const {
    return simplex_.optimum().dual(dissipation_row()) != 0;
  }

  void add(const StaticCut& cut);
  [[nodiscard]] std::size_t cuts() const { return cuts_; }

  /// Sets the decided signs and removes earlier ones.
  void decide(const Signs& signs);

  /// @return false if no optimum has passed its check, or the solve was stopped
  bool solve();
  /// True if the last solve was stopped.
  [[nodiscard]] bool is_interrupted() const;
  /// True if the last solve has shown that no point satisfies all rows and bounds.
  [[nodiscard]] bool is_infeasible() const {
    return std::holds_alternative<linear::CheckedInfeasibility>(simplex_.answer());
  }

  // Of the last solve, which has returned true:

  [[nodiscard]] double objective() const { return simplex_.optimum().objective(); }
  [[nodiscard]] Relaxed relaxed() const;
  [[nodiscard]] StaticProof proof() const;

  /// The basis for a warm start; with it the result does not depend on other programs solved since.
  [[nodiscard]] linear::Basis basis() const { return simplex_.basis(); }
  void set_basis(const linear::Basis& basis) { simplex_.set_basis(basis); }

  /// Removes the cuts from `first` on.
  void drop_cuts_from(std::size_t first);

  [[nodiscard]] std::uint64_t solves() const { return simplex_.solves(); }
  [[nodiscard]] std::uint64_t iterations() const { return simplex_.iterations(); }

 private:
  [[nodiscard]] std::vector<int> members_without_choice() const;
  [[nodiscard]] bool has_margin(double share) const;
  [[nodiscard]] int dissipation_row() const { return model_.member_count() + 1; }
  [[nodiscard]] int first_cut_row() const { return first_cut_row_; }
  [[nodiscard]] int gamma_column(int j) const {
    return model_.free_count() + 2 * model_.member_count() + j;
  }

  const problems::LimitModel& model_;
  double alpha_;
  support::Stop stop_;
  Eigen::VectorXd reduction_;  // n^m
  Signs signs_;
  std::vector<int> along_;  // the variable d_j'u, by column of T
  linear::CheckedSimplex simplex_;
  int first_cut_row_;
  std::size_t cuts_ = 0;
};

}  // namespace kusabi::limit
