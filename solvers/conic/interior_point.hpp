// InteriorPoint: primal-dual interior-point method for the standard form of a node program:
//
//   min c'x  s.t.  A x - v = b,  x in Q_d^k,  v >= 0        max b'y  s.t.  z = c - A'y in Q_d^k,
//                                                            y_j >= 0 for the rows with a slack.
//
// Nesterov-Todd scaling, Mehrotra's predictor and corrector, normal equations M = A W^2 A' of size
// m x m by Cholesky. The names are those of the literature: W, w, eta and lambda the scaling, its
// point, its factor and the scaled iterate; nu = (x'z + v'y) / degree the complementarity of an
// average pair (mu in the literature; here mu is friction); sigma the centring parameter; alpha the
// step lengths. The primal start is infeasible. The dual start is feasible by construction and z is
// recomputed from y each time, so that b'y is a lower bound of the optimal value throughout, up to
// the rounding of one product. The node solver turns both sides into a bracket of t*.
//
// The rigid-body modes of an unconstrained body add free columns to A, H alpha, and H'y = 0 to the
// dual program. The start does not satisfy this equation; a full step does. With rho H H' added to
// M, which changes nothing where H'dy is given, the factor exists although U alone may not
// determine the reactions; the p equations are then solved with S = H'M^-1 H. The rows of cuts are
// eliminated (cut_elimination.hpp).
#pragma once

#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "solvers/conic/cone.hpp"
#include "solvers/conic/cut_elimination.hpp"
#include "solvers/conic/node_program.hpp"
#include "solvers/conic/normal_equations.hpp"
#include "solvers/conic/pack.hpp"

namespace kusabi::conic {

/// Squared distances from a point of a relaxation to its faces, in the metric of the ellipsoid
/// around the point. Around the centre every inequality is at a distance of at least 1 (times a
/// common factor nu). They do not depend on units, and take all constraints into account: if two
/// candidates can hardly separate from each other, a face that is far for one is far for the other.
struct FaceDistances {
  double separation = 0;  ///< to x_i = 0
  double contact = 0;     ///< to v_i = 0
};

/// One run of the iteration at a time, on storage allocated once for the largest node. Per
/// iteration call dual_value(), factorise(), optionally project(), then advance().
///
/// Cones and rows are processed in packs. The last pack is padded by cones and rows without
/// coefficients, whose z stays at the identity and whose x and y do not change.
template <int D, class Real = double>
class InteriorPoint {
 public:
  using Vector = VectorOf<Real>;
  using Points = ConePoints<D, Real>;
  using Program = NodeProgram<D, Real>;

  /// Allocates for any node of this program.
  explicit InteriorPoint(const Program& program);

  /// Sets the start: x and v multiples of the identity, y on the rows with a slack so small that z
  /// is well inside the cones. It depends on the node only.
  void start(const Program& program);

  /// Sets the start to the last iterate of another run for the same node in shorter numbers, a little
  /// towards the ordinary start.
  /// @return false if it is outside the cones
  template <class Shorter>
  bool start_from(const InteriorPoint<D, Shorter>& other,
                  const NodeProgram<D, Shorter>& other_program, const Program& program);

  /// b'y, a lower bound of the optimal value, since y is dual feasible.
  Real dual_value(const Program& program) const { return program.right_side().dot(y_); }
  /// y, m + p numbers, padded.
  const Vector& multipliers() const { return y_; }

  /// Computes the scaling at the current point and factorises the normal equations.
  /// @return false if rounding has used up the digits of M
  bool factorise(const Program& program);

  /// x + W^2 A' M^-1 (b - A x + v): the point that satisfies the equations and is nearest to x in
  /// the norm of the scaling. It may lie outside the cones. Call after factorise().
  const Points& project(const Program& program);
  /// Projects an already projected point again, whose equations still have the residual
  /// `discrepancy` (m, padded): near the end M is ill-conditioned and one projection leaves a
  /// visible error.
  const Points& project_again(const Vector& discrepancy, const Program& program);

  /// The change of a projected point that removes this residual, and of its alpha. Call after
  /// factorise().
  const Points& correction(const Vector& discrepancy, const Program& program, Vector& motion);

  /// x'z + v'y, at the last factorise().
  const Real& complementarity() const { return complementarity_; }

  /// alpha of the projected point: one number for each free column.
  const Vector& motion() const { return motion_; }

  /// Moves to the point of the central path with this complementarity, as near as a few steps
  /// allow, and factorises there. Call after factorise().
  /// @return false if rounding has used up the digits
  bool centre(const Program& program, Real complementarity);

  /// Computes the face distances of the candidates that have both a cone and a slack, from the
  /// point of the last factorise().
  /// @pre one cone per candidate, and no rigid-body modes
  /// @param distances m
  void measure_faces(const Program& program, std::vector<FaceDistances>& distances);

  /// One predictor-corrector step. Call after factorise().
  /// @return false if the step is too short to change the bracket
  bool advance(const Program& program);

 private:
  template <int, class>
  friend class InteriorPoint;

  using Cones = ConePoint<D, Packed<Real>>;  // points of as many cones as there are lanes

  using Square = Eigen::Matrix<Real, D, D>;
  using Scaling = NesterovToddScaling<D, Packed<Real>>;

  static constexpr int width = lanes<Real>;

  // Reciprocals of the largest step lengths that stay inside, or zero if every length does.
  struct InverseStepLengths {
    Real dual, primal;
  };

  static Cones load_cones(const Points& points, int cone);
  static void store_cones(Points& points, int cone, const Cones& values);
  const Scaling& scaling(int cone) const {
    return scaling_[static_cast<std::size_t>(cone / width)];
  }

  // W of a cone.
  Square matrix_of(int cone) const;

  // Adds rho H H' to M; returns H'y, the residual of the equations of the modes.
  Vector regularise_modes(const Program& program);
  // Factorises S; false if it is singular.
  bool factorise_schur(const Program& program);
  // Corrects the two solutions of factorise() for the modes.
  bool solve_modes(const Program& program, const Vector& unbalanced);
  // Corrects a solution M^-1 g such that H'y = 0; returns alpha.
  Vector balance(const Program& program, Vector& solution);
  // Weights of a residual into trial_; returns their alpha, if there are modes.
  Vector solve_residual(const Vector& discrepancy, const Program& program);
  // Subtracts M^-1 H motion.
  void subtract(const Program& program, const Vector& motion, Vector& solution);

  // One step towards complementarity_ = complementarity in all pairs; returns its kind.
  enum class Step { full, shortened, failed };
  Step centring_step(const Program& program, Real complementarity);

  // Adds W^2 A' weights to the projected point.
  KUSABI_ALSO_FOR_AVX2 void shift_projected(const Program& program, const Vector& weights);
  // z = c - A'y; returns true if it is inside the cones and y > 0 on the rows with a slack.
  KUSABI_ALSO_FOR_AVX2 bool refresh_dual(const Program& program, const Vector& y);
  // Scales x, z and A in all cones, v and y in all rows; sets the residual b - A x + v. Returns the
  // largest entry on the diagonals of W.
  KUSABI_ALSO_FOR_AVX2 Real scale(const Program& program);
  // B = A W, or its replacement if there are cuts.
  KUSABI_ALSO_FOR_AVX2 void scale_matrix(const Program& program);
  PackedColumns<Real> scaled_columns(const Program& program) const;
  // Replaces g by M^-1 g. @pre M has been factorised
  void solve(Vector& whole);
  // Factorises M and solves for predictor_ and correction_.
  bool factorise_and_solve();
  // W dz = -W A' dy and W^-1 dx = q - lambda - W dz in both kinds of cone, where step_x_ and
  // step_v_ hold q.
  KUSABI_ALSO_FOR_AVX2 InverseStepLengths directions(const Program& program, const Vector& dy);
  // The q of the corrector, with lambda o q = sigma nu e - alpha dx~ o dz~ (alpha the length of the
  // predictor's step), into step_x_ and step_v_, and the right side A W q into trial_.
  KUSABI_ALSO_FOR_AVX2 void correct(const Program& program, Real sigma_nu, Real affine_length);
  KUSABI_ALSO_FOR_AVX2 bool move_primal(const Program& program, Real step_length);
  bool move_dual(const Program& program, Real step_length);
  // Columns of a cone, and that of its slack, as rows of faces_, for measure_faces().
  typename CutElimination<D, Real>::Part face_rows(const Program& program, int cone, int first_row);

  Points x_, z_, projected_;
  Vector v_, y_;                  // by row; v is used on the rows with a slack only
  std::vector<Scaling> scaling_;  // of the cones
  Vector present_;                // one for each cone, zero for the padding
  Vector w_, lambda_;             // of the rows: sqrt(v / y) and sqrt(v y)
  Vector weights_;                // diagonal contribution of the slacks to M
  Vector scaled_matrix_;          // B = A W
  CutElimination<D, Real> elimination_;
  Vector along_;                                // addend to faces_ by a cut
  Vector reduced_first_, reduced_second_;       // right sides without the rows of cuts
  NormalEquations<Real> normal_equations_;      // M = B B' + diag(w^2)
  MatrixOf<Real> reduced_modes_;                // (L^-1 H)'
  Vector along_motion_;                         // M^-1 H alpha
  MatrixOf<Real> faces_;                        // rows of B' and of diag(w), then these times L^-T
  Eigen::LLT<MatrixOf<Real>> schur_;            // of S
  Vector motion_;                               // alpha
  Vector predictor_, correction_, dy_, trial_;  // m
  Points step_x_, step_z_;                      // scaled: W^-1 dx, W dz
  Points products_;                             // A' dy, W q and similar products
  Vector step_v_, step_y_;                      // scaled, by row
  Real complementarity_ = 0;                    // x'z + v'y
};

}  // namespace kusabi::conic
