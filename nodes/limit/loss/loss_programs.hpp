// Linear programs on a truss without some of its members: its load factor, (5) of the limit paper,
// and stress states of few members that carry a factor not below a target under every load.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "nodes/limit/model/load_factor.hpp"
#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/basis.hpp"
#include "solvers/linear/checked_simplex.hpp"
#include "support/index_set.hpp"
#include "support/stop.hpp"
#include "verify/limit/stress_state.hpp"

namespace kusabi::limit {

/// Reductions of the yield forces of a carrying stress state, relative: the margin of its proof.
/// The second one is used if a proof with the first one fails; the simplex method may violate
/// bounds by 1e-9.
inline constexpr double yield_margins[] = {1e-10, 4e-9};

/// Load factor after a loss, by alternating linear programs if loads are uncertain: an upper bound
/// of the least one. Its results depend on the arguments alone.
class RemainingFactor {
 public:
  /// @param alpha scaled; zero: the dead load as given @pre the model outlives this object
  RemainingFactor(const problems::LimitModel& model, double alpha);

  /// The least factor found, of one admissible load. @param start scaled; empty: none
  Descent solve(const support::IndexSet& lost, const Eigen::VectorXd& start,
                const support::Stop& stop);

  [[nodiscard]] std::uint64_t solves() const { return simplex_.solves(); }

 private:
  LoadResult result(const Eigen::VectorXd& dead, const support::Stop& stop);
  Descent descend(Eigen::VectorXd zeta, const support::Stop& stop);

  const problems::LimitModel& model_;
  double alpha_;
  linear::CheckedSimplex simplex_;
  linear::Basis first_;     // of the intact truss
  support::IndexSet lost_;  // in the last solve
};

/// Carrying stress states of small weighted sum of forces. Columns are forces and factor of the
/// dead load, (q_0, lambda_0), and of each uncertain load, (P_j, kappa_j):
///   minimise sum_i w_i (|q_0,i| + sum_j |P_ij|)
///   subject to B q_0 = f_D + lambda_0 f_R, B P_j = alpha t_j + kappa_j f_R,
///   -q^c <= q_0 -+ sum_j |P_j| <= q^t, lambda_0 - sum_j |kappa_j| >= target.
class StateProgram {
 public:
  /// Result of a solve.
  enum class Result { found, none, undetermined };

  /// @param alpha scaled; zero: the dead load as given @param target scaled
  /// @pre the model outlives this object
  StateProgram(const problems::LimitModel& model, double alpha, double target,
               support::Stop stop = {});

  /// Makes the next result independent of earlier ones.
  /// @param target scaled
  void restart(double target);

  /// @param lost without stress @param avoided members with a large weight
  /// @param free members with a small weight @param margin relative reduction of the yield forces
  Result solve(const support::IndexSet& lost, const support::IndexSet& avoided,
               const support::IndexSet& free, double margin);

  /// In the units of the problem; the support is the members with stress.
  /// @pre the result of the last solve was `found`
  [[nodiscard]] verify::StressState state() const;

  /// Members of the basis of the solution, with stress or without: together with those of state()
  /// their forces can usually balance any load.
  /// @pre the result of the last solve was `found`
  [[nodiscard]] support::IndexSet basic_members() const;

  [[nodiscard]] std::uint64_t solves() const { return simplex_.solves(); }

 private:
  [[nodiscard]] int force_column(std::size_t load, int member) const;
  [[nodiscard]] int factor_column(std::size_t load) const;
  [[nodiscard]] linear::LinearProgram program() const;

  const problems::LimitModel& model_;
  std::vector<Eigen::VectorXd> loads_;  // f_D, then each alpha t_j
  support::Stop stop_;
  linear::CheckedSimplex simplex_;
  linear::Basis first_;
};

}  // namespace kusabi::limit
