// Search for a certificate of a target: Douglas-Rachford splitting between A X = T and the rows, as
// a reflected Halpern iteration with restarts.
//
//   x = rows(z),  y = affine(2 x - z),  z <- (k+1)/(k+2) (z + 2 (y - x)) + 1/(k+2) z_0
//
// z_0 is the initial point of the current epoch, which has k steps; a new epoch begins when |y - x|
// has decreased sufficiently.
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "nodes/limit/splitting/affine_program.hpp"
#include "nodes/limit/splitting/affine_projection.hpp"
#include "nodes/limit/splitting/column_blocks.hpp"
#include "nodes/limit/splitting/row_projection.hpp"

namespace kusabi::limit::splitting {

class AffineIteration {
 public:
  /// @pre all outlive this object
  AffineIteration(const AffineProgram& program, AffineProjection& projection,
                  const Sharing& sharing);

  /// @param target the factor of the certificate, scaled; minus infinity: any
  void step(double target);

  [[nodiscard]] int steps() const { return steps_; }
  /// |y - x| of the last step.
  [[nodiscard]] double residual() const { return residual_; }
  /// Of the last step: the multiplier of the dead load, unscaled; on every rank. Every rank makes
  /// the same call.
  [[nodiscard]] Eigen::VectorXd motion() const;

  /// A X = T up to about the last bit: the forces of the loads are a certificate if they leave a
  /// margin. Column 0, including lambda_0, is that of the dead load.
  [[nodiscard]] const ColumnBlocks& affine_point();
  /// Each row within its bounds: x of the last step except for its factor.
  [[nodiscard]] double row_point(int row, int column) const;

 private:
  [[nodiscard]] Segment reflected(bool first, int row, const Segment& z) const;
  void move(double relaxation, double share);
  void end_of_epoch();

  const AffineProgram& program_;
  AffineProjection& projection_;
  const Sharing& sharing_;
  RowProjection rows_;
  ColumnBlocks z_;
  double factor_ = 0;  // lambda_0 of z, where z itself has zero
  std::vector<Segment> anchor_;
  double anchor_factor_ = 0;
  ColumnBlocks y_;
  Eigen::VectorXd motion_;
  int steps_ = 0;
  int epoch_ = 0;  // steps of the epoch
  double residual_ = std::numeric_limits<double>::infinity();
  double first_residual_ = 0;  // of the epoch
  double last_residual_ = std::numeric_limits<double>::infinity();
};

}  // namespace kusabi::limit::splitting
