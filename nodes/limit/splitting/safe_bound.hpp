// Bound of the worst case by any set of static cuts: with their shares, limit analysis (5)
// determines the best state of the dead load within the remaining yield forces.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/checked_simplex.hpp"
#include "support/stop.hpp"

namespace kusabi::limit::splitting {

/// Proved bound of the cuts, scaled.
struct SafeState {
  double bound = 0;        ///< factor - sum_j |kappa_j|
  double factor = 0;       ///< lambda_0
  Eigen::VectorXd forces;  ///< q_0, n^m
};

class SafeStates {
 public:
  /// @pre the model outlives this object
  explicit SafeStates(const problems::LimitModel& model, support::Stop stop = {});

  void set_stop(support::Stop stop) { stop_ = std::move(stop); }

  /// Replaces the dead load, that of the model. @param dead n^d, scaled
  void set_load(const Eigen::VectorXd& dead);

  /// Makes the next state() start from this basis of (5).
  void start_from(const linear::Basis& basis) { simplex_.set_basis(basis); }

  /// @param taken sum_j |P_ij| for each member, then sum_j |kappa_j|
  /// @param room reduction of each yield force, n^m
  /// @return nothing if too little remains, or no answer passes its check
  std::optional<SafeState> state(const std::vector<double>& taken, const Eigen::VectorXd& room);

  /// After a failure: the members elongated by a motion which proves that too little remains;
  /// empty: another reason.
  [[nodiscard]] std::vector<int> members_in_the_way() const;

 private:
  const problems::LimitModel& model_;
  support::Stop stop_;
  linear::CheckedSimplex simplex_;
};

}  // namespace kusabi::limit::splitting
