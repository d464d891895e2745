// Anderson acceleration of an iteration on many columns: the result of a cycle of steps minus a
// combination of its changes between cycles, whose coefficients minimise the change of the point.
//
// With r_k = f(z_k) - z_k, the next point is f(z_k) - sum_i g_i df_i, where g minimises
// |r_k - sum_i g_i dr_i|; df_i and dr_i are differences between successive cycles.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "nodes/limit/splitting/column_blocks.hpp"

namespace kusabi::limit::splitting {

/// Columns of this rank, and numbers that every rank has.
struct MixedPoint {
  ColumnBlocks columns;
  Eigen::VectorXd rest;
};

class Acceleration {
 public:
  /// @param start z_0 @param sharing outlives this object
  Acceleration(const MixedPoint& start, const Sharing& sharing)
      : sharing_(sharing), change_(start) {}

  /// Replaces f(z_k), the result of a cycle, by z_{k+1}. Every rank makes the same call.
  void advance(MixedPoint& point);

  /// The cycle after advance() does worse than its predecessor: continues at f(z_k) without
  /// history.
  void reject(MixedPoint& point);

  /// True if the last point is an extrapolation.
  [[nodiscard]] bool extrapolates() const { return extrapolates_; }

 private:
  void remember(const MixedPoint& result);
  [[nodiscard]] Eigen::VectorXd coefficients();

  const Sharing& sharing_;
  MixedPoint change_;                // z_k, and within advance() r_k
  std::vector<MixedPoint> last_;     // r_k and f(z_k) of the last cycle; empty: none
  std::vector<MixedPoint> changes_;  // dr
  std::vector<MixedPoint> results_;  // df
  Eigen::MatrixXd gram_;             // dr_i'dr_j
  std::size_t oldest_ = 0;
  bool extrapolates_ = false;
};

}  // namespace kusabi::limit::splitting
