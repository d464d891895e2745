// NodeProgram: the cone program of one node (U, R) of the tree of sign patterns, in standard form.
//
// The wedged paper, Algorithm 5.1, bounds a node by the program (18). Here the form of (23) is used
// at every node, with the cone relaxed by t as well, since (18) as printed can be infeasible.
//
//   max t  s.t.  (F r)_{n,i} = 0 (i in U),   (F r)_{n,j} >= t (j not in U),
//                ||r_{t,i}|| + t <= mu_i r_{n,i} (i in C),   r_i = 0 (i in R),   sum_i r_{n,i} = 1
//
// with C the complement of R. The substitution x_i = (r_{n,i} - t / mu_i, r_{t,i} / mu_i) maps the
// friction cone of a candidate to the second-order cone, and the sum gives t = (1 - sum_i x_i0) /
// omega with omega = sum_C 1 / mu_i. Without friction r_t = 0, t <= r_{n,i} and 1 replaces 1 /
// mu_i. With a slack v_j for each gap row:
//
//   min c'x  s.t.  A x - v = b (v_j only for j not in U),  x_i in Q_d,  v >= 0,
//
// with c = e in each cone. There is exactly one row for each candidate, so the normal equations are
// m x m.
//
// An unconstrained body adds its p rigid-body modes G: u_n = F_n r + H alpha with alpha free, H the
// normal rows of G, and p rows G'r = 0 without a slack. There are then m + p rows and free columns
// H (docs/theory/wedged.md, "Unconstrained bodies"). In extended precision, modes that do not
// displace the rows of the node and redundant equations are omitted (docs/theory/wedged.md,
// "Precision levels"); an elimination for each node would take doubles longer than an iteration.
//
// Cuts (cut.hpp) are rows with a slack after all of these. They are not stored: with row i of A in
// the place of F_i and of t, that of a cut of candidate i is
//
//   C_i = -displacement A_i - reaction e_i0' + gamma_i 1',     1'x = sum_k x_k0,
//
// and its free columns are those of row i times -displacement.
//
// A load is a last candidate without friction that has a cone and no row: its reaction is its
// amount tau >= t, and its displacement is not constrained (docs/theory/loads.md).
//
// A candidate may have several cones, whose reactions sum to its own and which share its row:
// polyhedral friction cones are thus solved as sums of plane ones
// (nodes/wedged/relaxation/facets.hpp). docs/theory/wedged.md, "Standard form with m rows", derives
// it.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "solvers/conic/bounds.hpp"
#include "solvers/conic/columns.hpp"
#include "solvers/conic/cut.hpp"
#include "solvers/conic/iteration_rules.hpp"
#include "solvers/conic/motions.hpp"
#include "solvers/conic/pack.hpp"
#include "support/index_set.hpp"

namespace kusabi::conic {

/// Points of the cones: component d of cone c at (c, d). The rows are padded to whole packs;
/// padding is not part of the point.
template <int D, class Real = double>
using ConePoints = Eigen::Matrix<Real, Eigen::Dynamic, D>;

/// The part of a cut's row besides the row of its candidate in A.
template <class Real>
struct CutRow {
  int candidate = 0;
  int cone = -1;  ///< of the standard form; -1: the candidate has none
  Real displacement = 0, reaction = 0;
  Real gamma = 0;
};

/// Data of the node programs of one contact problem, and the standard form of the last selected
/// node. Owns all its storage: select() allocates only for cuts of an unconstrained body.
template <int D, class Real = double>
class NodeProgram {
 public:
  using Vector = VectorOf<Real>;
  using Matrix = MatrixOf<Real>;

  /// @param compliance F, Dm x Dm, symmetric positive definite, ordered by candidate and within it
  ///        (n, t1[, t2]); scaled so that reactions and displacements are comparable
  /// @param friction mu, m numbers: 0, where r_t = 0, or 1e-6 to 1e6
  /// @throws std::invalid_argument if the sizes disagree or a number is out of range
  NodeProgram(const Matrix& compliance, std::span<const double> friction);

  /// With several cones per candidate: all sizes above except m count cones.
  /// @param owners candidate of each cone: 0, ..., 0, 1, ..., 1, ..., m - 1
  /// @param motions of an unconstrained body
  /// @param loads number of the last candidates that are loads
  NodeProgram(const Matrix& compliance, std::span<const double> friction, std::vector<int> owners,
              Motions<Real> motions = {}, int loads = 0);

  /// Allocates room for cuts; initially there is none.
  void make_room(int max_cuts);

  /// Sets mu, one number per cone, for the next calls of select().
  /// @throws std::invalid_argument if the size differs or a number is out of range
  void set_friction(std::span<const double> friction);

  /// Assembles the standard form of the node with the candidates of `contact` in U and those of
  /// `separated` in R. The candidates of `ignored` have neither a reaction nor a row: r = 0, and
  /// u_n is free.
  /// @param cuts at most one per candidate, which is not ignored and has one cone
  /// @param lifted candidates that are omitted from the rows, since a motion opens them
  /// @throws std::invalid_argument if the sets overlap, if they contain a candidate that does not
  ///         exist, or if there is no room for the cuts
  void select(const support::IndexSet& contact, const support::IndexSet& separated,
              const support::IndexSet& ignored = {}, std::span<const Cut> cuts = {},
              const support::IndexSet& lifted = {});

  int candidates() const { return owners_.back() + 1; }
  /// Number of rows: m + p and the cuts.
  int rows() const { return first_cut() + static_cast<int>(cuts_.size()); }
  /// m + p: the row of the first cut.
  int first_cut() const { return candidates() + motions_.count(); }
  /// Maximum of rows() over all nodes.
  int max_rows() const { return first_cut() + max_cuts_; }
  int max_cuts() const { return max_cuts_; }
  const Motions<Real>& motions() const { return motions_; }
  /// H of the node, with the rows of cuts: rows() numbers padded with zeros, one column for each
  /// mode with a normal part.
  const Matrix& free_columns() const { return free_columns_; }
  /// Number of cones of all candidates: m unless a candidate has several.
  int max_cones() const { return static_cast<int>(friction_.size()); }

  /// C, the cones of the candidates that may have a reaction; cone c of the standard form is the
  /// cone cones()[c] of the problem.
  const std::vector<int>& cones() const { return cones_; }
  /// The candidates not in U: the rows with a slack.
  const std::vector<int>& gap_rows() const { return gap_rows_; }
  /// The sets of the node.
  NodeSets sets() const { return {cones_, gap_rows_, contact_rows_, contact_, cuts_}; }
  /// Number of rows with a slack.
  std::size_t slacks() const { return slacks_; }
  /// Rows without entries: of the candidates that are ignored or lifted, of the loads, and of
  /// redundant equations of equilibrium.
  const support::IndexSet& empty_rows() const { return empty_rows_; }
  /// Candidates with a row that is not empty, in order.
  std::vector<int> candidates_with_row() const;
  int loads() const { return loads_; }

  /// By cone.
  const std::vector<double>& friction() const { return friction_; }
  const std::vector<int>& owners() const { return owners_; }
  const Matrix& compliance() const { return compliance_; }

  /// Cone columns of A, first_cut() x D|C|, rows and cones padded with zeros.
  PackedColumns<Real> matrix() const {
    const auto height = static_cast<int>(normal_compliance_.rows());
    return {matrix_.data(), height, D, static_cast<int>(cones_.size()), stride()};
  }
  /// Rows of the cuts.
  const std::vector<CutRow<Real>>& cut_rows() const { return cut_rows_; }
  /// sum = [A; C] x: rows() numbers, padded with zeros.
  void multiply(const ConePoints<D, Real>& x, Vector& sum) const;
  /// products = A'y + C'eta of the rows() numbers (y, eta), padded with zeros.
  void multiply_transposed(const Vector& weights, ConePoints<D, Real>& products) const;
  /// b, rows() numbers padded with zeros to max_rows(), as is slack().
  const Vector& right_side() const { return right_side_; }
  /// 1 for each row with a slack, 0 for the others and the padding.
  const Vector& slack() const { return slack_; }

  /// t = (1 - value) / omega: the value t of an objective value c'x or b'y.
  Real level(const Real& value) const { return (1.0 - value) / omega_; }

  /// Reaction r (Dm, zero on R) of a point x of the cones.
  void reaction(const ConePoints<D, Real>& x, Vector& r) const;
  /// Change of the reaction with a change of such a point.
  void reaction_change(const ConePoints<D, Real>& x, Vector& r) const;

  /// Largest t that the friction cones permit for a reaction: min over C of mu_i r_{n,i} -
  /// ||r_{t,i}||.
  double friction_level(const Vector& r) const;

  /// H, one row for each candidate, of all modes with a normal part.
  const Matrix& normal_motions() const { return normal_motions_; }
  /// alpha of these modes, from that of the free columns.
  Vector motion(const Vector& alpha) const {
    return is_reduced() ? Vector(motion_basis_ * alpha) : alpha;
  }
  /// Replaces y of the rows by the multipliers of pull().
  void to_multipliers(Vector& y) const {
    if (is_reduced()) of_modes(y) = equation_basis_ * of_modes(y);
  }

  /// The reverse, up to the rounding of doubles.
  void from_multipliers(Vector& y) const;
  /// Replaces the residual of G'r = 0 by that of the equations of the rows.
  void to_rows(Vector& residual) const {
    if (is_reduced()) of_modes(residual) = equation_basis_.transpose() * of_modes(residual);
  }

  /// u_n = F_n r + H alpha, then G'r: m + p numbers, padded; valid until the next call.
  /// @param motion alpha of an unconstrained body
  const Vector& normal_displacements(const Vector& r, const Vector& motion = {});
  /// Residual of the equations at the last normal_displacements(): rows() numbers padded with
  /// zeros, zero at rows with a slack. Overwrites them.
  const Vector& discrepancy();

  /// w = sum_i y_i (row (n, i) of F) + G beta, and the contribution of the cuts' multipliers: Dm
  /// numbers, valid until the next call.
  /// @param y m + p numbers, beta last, then one per cut
  const Vector& pull(const Vector& y);

  /// u = F r + G alpha, Dm.
  void displacement(const Vector& r, const Vector& motion, Vector& u) const {
    u.noalias() = compliance_ * r;
    if (motion.size() > 0) u += motions_.at_cones.leftCols(motion.size()) * motion;
  }

 private:
  // Reaction of a point with this value of t.
  void reaction_at(const ConePoints<D, Real>& x, const Real& t, Vector& r) const;
  // True if redundant modes and equations are omitted.
  bool is_reduced() const { return extended<Real> && motions_.count() > 0; }
  void reduce_modes();
  auto of_modes(Vector& by_row) const { return by_row.segment(candidates(), motions_.count()); }
  int stride() const { return padded_cones_; }
  // Column of component d of the cone c of the standard form.
  auto column(Eigen::Index d, Eigen::Index c) {
    const Eigen::Index height = normal_compliance_.rows();
    return Eigen::Map<Vector>(matrix_.data() + (d * stride() + c) * height, height);
  }
  void fill_columns();
  void fill_cuts();

  Matrix compliance_;             // F
  Motions<Real> motions_;         // G
  Matrix normal_compliance_;      // rows (n, i) of F, then G': both padded with zeros
  Matrix normal_motions_;         // H, padded
  Matrix free_columns_;           // H without the empty rows, with the cuts
  Matrix motion_basis_;           // of the modes that displace a row, if is_reduced()
  Matrix equation_basis_;         // T, p x p: the last rows are T'G'r = 0, of which some are empty
  std::vector<double> friction_;  // by cone, as the next
  std::vector<int> owners_;
  std::vector<int> cones_, gap_rows_, contact_rows_;  // U: the rows without a slack
  std::vector<Cut> cuts_;
  std::vector<CutRow<Real>> cut_rows_;
  int max_cuts_ = 0, padded_cones_, loads_;
  Vector matrix_;      // A, room for all cones and rows
  Vector right_side_;  // b
  Vector slack_;
  Vector gap_;             // normal displacements, then the discrepancy
  Vector pull_;            // w
  mutable Vector forces_;  // coefficients of the rows of F, or of A, including the cuts
  support::IndexSet contact_, ignored_, empty_rows_;
  std::size_t slacks_ = 0;
  Real omega_ = 0;  // sum_C 1 / mu
};

}  // namespace kusabi::conic
