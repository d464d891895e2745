// A primal-dual interior-point iteration for the standard form of a node program:
//
//   min c'x  s.t.  A x - v = b,  x in Q_d^k,  v >= 0        max b'y  s.t.  z = c - A'y in Q_d^k,
//                                                            y_j >= 0 for the rows with a slack.
//
// Nesterov-Todd scaling, Mehrotra's predictor and corrector, normal equations M = A W^2 A' of size
// m x m by Cholesky. The primal start is infeasible; the dual start is feasible by construction and
// z is computed afresh from y each time, so b'y bounds the optimal value from below throughout, up
// to the rounding of one product. The node solver turns the two sides into a bracket of t*.
#pragma once

#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "nodes/conic/cone.hpp"
#include "nodes/conic/node_program.hpp"

namespace kusabi::conic {

/// One run of the iteration at a time, on storage that is allocated once for the largest node.
/// Per iteration call dual_value(), factorise(), project() where wanted, advance().
template <int D>
class InteriorPoint {
 public:
  /// Points of the cones, one cone a column; only the first |C| columns are in use.
  using Points = Eigen::Matrix<double, D, Eigen::Dynamic>;

  InteriorPoint(int candidates, int most_cones);

  /// Takes the start: x and v from the identity, y on the rows with a slack so small that z is
  /// well inside the cones. It depends on the node only.
  void start(const NodeProgram<D>& program);

  /// b'y, a lower bound of the optimal value: y is dual feasible.
  double dual_value(const NodeProgram<D>& program) const { return program.right_side().dot(y_); }
  /// y, m numbers.
  const Eigen::VectorXd& multipliers() const { return y_; }

  /// Scales at the present point and factorises the normal equations.
  /// @return false when rounding has used up the digits of M
  bool factorise(const NodeProgram<D>& program);

  /// x + W^2 A' M^-1 (b - A x + v): the point that satisfies the equations and is nearest to x in
  /// the norm of the scaling. It may lie outside the cones. Call after factorise().
  const Points& project(const NodeProgram<D>& program);
  /// The same for an already projected point whose equations still miss by `discrepancy` (m):
  /// near the end M is ill-conditioned and one projection leaves a visible error.
  const Points& project_again(const Eigen::VectorXd& discrepancy, const NodeProgram<D>& program);

  /// One predictor-corrector step. Call after project().
  /// @return false when the step is too short to matter
  bool advance(const NodeProgram<D>& program);

 private:
  // Adds W^2 A' weights = W B' weights to the projected point.
  void shift_projected(const Eigen::VectorXd& weights, Eigen::Index count);
  // z = c - A'y; whether it is inside the cones and y > 0 on the rows with a slack.
  bool refresh_dual(const NodeProgram<D>& program, const Eigen::VectorXd& y);
  // W dz = -W A' dy, in both kinds of cone. Like the next one it returns the reciprocal of the
  // largest step that stays inside, or zero when all do.
  double dual_direction(const NodeProgram<D>& program, const Eigen::VectorXd& dy);
  // W^-1 dx = q - lambda - W dz, where step_x_ and step_v_ hold q.
  double primal_direction(const NodeProgram<D>& program);
  bool move_primal(const NodeProgram<D>& program, double step);
  bool move_dual(const NodeProgram<D>& program, double step);

  Points x_, z_, projected_;
  Eigen::VectorXd v_, y_;                      // by row; v is used on the rows with a slack only
  std::vector<Scaling<D>> scaling_;            // of the cones
  Eigen::VectorXd slack_scale_, slack_point_;  // w = sqrt(v / y) and lambda = sqrt(v y), by row
  Eigen::MatrixXd scaled_matrix_;              // B = A W, m x Dk
  Eigen::MatrixXd normal_matrix_;              // M = B B' + diag(w^2), lower half
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::VectorXd predictor_, correction_, dy_, trial_;  // m
  Points step_x_, step_z_;                               // scaled: W^-1 dx, W dz
  Eigen::VectorXd step_v_, step_y_;                      // scaled, by row
};

extern template class InteriorPoint<2>;
extern template class InteriorPoint<3>;

}  // namespace kusabi::conic
