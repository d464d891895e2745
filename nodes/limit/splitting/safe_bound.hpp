// A bound of the worst case by any p static cuts at all: with their shares, limit analysis (5)
// tells the best state of the dead load, in what they leave of the yield forces.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/simplex.hpp"
#include "support/stop.hpp"

namespace kusabi::limit::splitting {

/// What the cuts prove, scaled.
struct SafeState {
  double bound = 0;        ///< factor - sum_j |kappa_j|
  double factor = 0;       ///< lambda_0
  Eigen::VectorXd forces;  ///< q_0, n^m
};

class SafeBound {
 public:
  /// The model must outlive it.
  explicit SafeBound(const problems::LimitModel& model, support::Stop stop = {});

  void set_stop(support::Stop stop) { stop_ = std::move(stop); }

  /// @param taken sum_j |P_ij| for each member, then sum_j |kappa_j|
  /// @param room what is left of each yield force besides, n^m
  /// @return nothing if too little is left, or the simplex method fails
  std::optional<SafeState> state(const std::vector<double>& taken, const Eigen::VectorXd& room);

  /// After it: the members that a motion stretches which shows that too little is left; empty: that
  /// is not why.
  [[nodiscard]] std::vector<int> members_in_the_way();

 private:
  const problems::LimitModel& model_;
  support::Stop stop_;
  linear::Simplex simplex_;
};

}  // namespace kusabi::limit::splitting
