// Projection of rows onto the face: two thresholds for each row, one for each sign, coupled by the
// state under the critical load.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "nodes/limit/splitting/column_blocks.hpp"
#include "nodes/limit/splitting/face.hpp"

namespace kusabi::limit::splitting {

class FaceProjection {
 public:
  /// @pre all outlive this object
  FaceProjection(const AffineProgram& program, const Face& face, const Sharing& sharing);

  /// Finds the thresholds. @param state a of z, n^m + 1
  void find(const ColumnBlocks& z, const Eigen::VectorXd& state);

  /// z minus its projection, for a row of a block.
  [[nodiscard]] KUSABI_INLINE Segment cut_off(int row, const Segment& z,
                                              const Segment& works) const {
    const auto i = static_cast<std::size_t>(row);
    const Lanes upper = upper_[i];
    const Lanes lower = -lower_[i];
    Segment cut;
    for (int h = 0; h < block_lanes; ++h) {
      cut.part[h] = clamped(z.part[h], lower, upper);
      if (signed_[i]) cut.part[h] = where_positive(works.part[h], cut.part[h], z.part[h]);
    }
    return cut;
  }

  /// a of the projection.
  [[nodiscard]] const Eigen::VectorXd& state() const { return state_; }
  /// One for each column of a block whose load does work, otherwise zero.
  [[nodiscard]] const Segment& works(int first_column) const {
    return works_[static_cast<std::size_t>(first_column / block_columns)];
  }

 private:
  struct Sums {
    double above = 0;
    double count_above = 0;
    double below = 0;
    double count_below = 0;
  };
  void evaluate(const ColumnBlocks& z);
  [[nodiscard]] bool newton(int row, const Sums& sums, int round);
  [[nodiscard]] bool newton_of_both(int row, const Sums& sums, int round);

  const AffineProgram& program_;
  const Face& face_;
  const Sharing& sharing_;
  std::vector<Segment> works_;
  std::vector<double> upper_;  // thresholds: larger numbers are decreased
  std::vector<double> lower_;  // numbers below minus this are increased
  std::vector<bool> signed_;   // rows with numbers of one sign
  Eigen::VectorXd given_;      // a of z
  Eigen::VectorXd state_;
  std::vector<int> active_;
  std::vector<Sums> sums_;
  std::vector<double> shared_;
};

}  // namespace kusabi::limit::splitting
