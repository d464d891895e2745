// The nearest point whose rows are within their l1 balls: each row has a threshold by which all its
// numbers are drawn to zero, found by Newton's method from the threshold of the step before.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "nodes/limit/splitting/column_blocks.hpp"

namespace kusabi::limit::splitting {

class RowProjection {
 public:
  /// @param capacity of each member; the last row is lambda_0 - sum |kappa_j| >= target
  RowProjection(const Eigen::VectorXd& capacity, const Sharing& sharing);

  /// Finds the thresholds. @param z the row of the factor without lambda_0: zero in column 0
  /// @param factor lambda_0 of z @param target minus infinity: none
  void find(const ColumnBlocks& z, double factor, double target);

  [[nodiscard]] double threshold(int row) const {
    return thresholds_[static_cast<std::size_t>(row)];
  }
  [[nodiscard]] std::vector<double>& thresholds() { return thresholds_; }

 private:
  void evaluate(const ColumnBlocks& z);
  [[nodiscard]] double newton(std::size_t place, double factor, double target) const;

  const Eigen::VectorXd& capacity_;
  const Sharing& sharing_;
  std::vector<double> thresholds_;
  std::vector<int> active_;    // rows that are still looked for
  std::vector<double> over_;   // sum of what is above the threshold, by active row
  std::vector<double> count_;  // how many are
  std::vector<double> shared_;
};

/// sum_j |y_ij| over all columns but the first, for each row. Every rank makes the same call.
std::vector<double> row_sizes(const ColumnBlocks& y, const Sharing& sharing);

/// Adds up numbers of all groups, in their order. @param per_group how many each group has
std::vector<double> added(std::vector<double>& numbers, std::size_t per_group,
                          const Sharing& sharing);

}  // namespace kusabi::limit::splitting
