// Search for a certificate on a face: Douglas-Rachford splitting between A [W; K] = alpha s t, the
// state in equilibrium with the critical load, and the rows of the face; with Anderson
// acceleration.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include "nodes/limit/splitting/acceleration.hpp"
#include "nodes/limit/splitting/affine_iteration.hpp"
#include "nodes/limit/splitting/affine_program.hpp"
#include "nodes/limit/splitting/affine_projection.hpp"
#include "nodes/limit/splitting/column_blocks.hpp"
#include "nodes/limit/splitting/face.hpp"
#include "nodes/limit/splitting/face_projection.hpp"

namespace kusabi::limit::splitting {

class FaceIteration {
 public:
  /// Starts from `start`. @pre all but `start` outlive this object. Every rank makes the same call.
  FaceIteration(const AffineProgram& program, AffineProjection& projection, const Sharing& sharing,
                Face face, AffineIteration& start);

  void step();

  [[nodiscard]] int steps() const { return steps_; }
  [[nodiscard]] double residual() const { return residual_; }

  /// P and kappa, A X = T up to about the last bit; column 0 is zero.
  [[nodiscard]] const ColumnBlocks& affine_point();

 private:
  void start_from(AffineIteration& start);
  void plain_step();
  void move_state(double& square);
  [[nodiscard]] Segment reflected(int first_column, int row, const Segment& z) const;

  const AffineProgram& program_;
  AffineProjection& projection_;
  const Sharing& sharing_;
  Face face_;
  FaceProjection rows_;
  MixedPoint point_;  // z, and a of z
  ColumnBlocks y_;
  // The state under the critical load: forces of members without elongation, and the factor.
  Eigen::SparseMatrix<double> still_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> factor_;
  Eigen::VectorXd still_load_;
  std::optional<Acceleration> acceleration_;
  int steps_ = 0;
  double residual_ = std::numeric_limits<double>::infinity();
};

}  // namespace kusabi::limit::splitting
