// Projection onto A X = T, sixteen columns at a time, with one sparse Cholesky factor of A D A'.
//
// In the norm sum_i x_i^2 / d_i the projection of w is y = w - D A' u, (A D A') u = A w - t. The
// multiplier u of the dead load is a motion that approaches the collapse of the truss.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "nodes/limit/splitting/affine_program.hpp"
#include "nodes/limit/splitting/column_blocks.hpp"

namespace kusabi::limit::splitting {

class AffineProjection {
 public:
  /// @param metric d, > 0, one for each column of A
  AffineProjection(const Eigen::SparseMatrix<double>& a, Eigen::VectorXd metric);

  /// True if there is a factor; required by all other calls.
  [[nodiscard]] bool definite() const { return definite_; }
  [[nodiscard]] const Eigen::VectorXd& metric() const { return metric_; }

  /// Begins the next block with these right-hand sides.
  /// @param loads t, by column; columns beyond `loads` have none
  void begin(const std::vector<SparseLoad>& loads, int first_column);
  /// Sets row i of the point w.
  KUSABI_INLINE void take(int row, const Segment& w) {
    for (auto at = first_[static_cast<std::size_t>(row)];
         at < first_[static_cast<std::size_t>(row) + 1]; ++at) {
      auto& target = solution_[static_cast<std::size_t>(place_[at])];
      for (int h = 0; h < block_lanes; ++h) target.part[h] += value_[at] * w.part[h];
    }
  }
  /// Called after all rows are set.
  void solve();
  /// Replaces row i of w by that of its projection.
  KUSABI_INLINE void project(int row, Segment& w) const {
    for (auto at = first_[static_cast<std::size_t>(row)];
         at < first_[static_cast<std::size_t>(row) + 1]; ++at) {
      const auto& source = solution_[static_cast<std::size_t>(place_[at])];
      for (int h = 0; h < block_lanes; ++h) w.part[h] -= scaled_[at] * source.part[h];
    }
  }
  /// u of one of the sixteen columns.
  [[nodiscard]] Eigen::VectorXd multipliers(int column) const;

 private:
  // A triangular factor by rows or by columns, without its diagonal.
  struct Triangle {
    std::vector<int> first;
    std::vector<int> place;
    std::vector<double> value;
  };
  static Triangle triangle(const Eigen::SparseMatrix<double>& matrix);

  bool definite_ = false;
  Eigen::VectorXd metric_;
  // A by columns; displacements in the order of the factor
  std::vector<std::size_t> first_;
  std::vector<int> place_;
  std::vector<double> value_;
  std::vector<double> scaled_;  // times d
  Triangle by_row_;             // of L, for L x = b
  Triangle by_column_;          // for L'x = b
  std::vector<double> inverse_diagonal_;
  std::vector<int> order_;  // index of a displacement
  std::vector<Segment> solution_;
};

}  // namespace kusabi::limit::splitting
