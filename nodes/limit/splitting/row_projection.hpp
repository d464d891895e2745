// Projection of rows onto their l1 balls: each row has a threshold by which its numbers are moved
// towards zero, found by Newton's method from the threshold of the previous step.
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

 private:
  void evaluate(const ColumnBlocks& z);
  [[nodiscard]] double newton(std::size_t place, double factor, double target) const;

  const Eigen::VectorXd& capacity_;
  const Sharing& sharing_;
  std::vector<double> thresholds_;
  std::vector<int> active_;    // rows that have not converged
  std::vector<double> over_;   // sum of numbers above the threshold, by active row
  std::vector<double> count_;  // their number
  std::vector<double> shared_;
};

/// sum_j |y_ij| over all columns but the first, for each row. Every rank makes the same call.
std::vector<double> row_sizes(const ColumnBlocks& y, const Sharing& sharing);

/// Adds up numbers of all groups, in their order. @param per_group number of each group
std::vector<double> added(std::vector<double>& numbers, std::size_t per_group,
                          const Sharing& sharing);

}  // namespace kusabi::limit::splitting
