// PlainSolver: solver of node programs in extended precision, for nodes that are numerically
// undecided in doubles.
//
// Standard form, iteration and proofs are those of node_program.hpp, interior_point.hpp and
// node_solver.hpp, written without optimisation for any scalar type. The higher precision levels
// are long double and 104 bits (nodes/wedged/tree/contact_solver.hpp).
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "solvers/conic/answer.hpp"
#include "solvers/conic/bounds.hpp"
#include "solvers/conic/cone.hpp"
#include "support/numbers/precise.hpp"
#include "support/stop.hpp"

namespace kusabi::conic {

/// Candidates with a reaction, and those with a gap, at a point of the relative interior of the
/// solutions of a degenerate node,
///   X = {r : u_n = 0 on U, r = 0 on R, u_n >= 0, r in the friction cones, sum r_n = 1}. No
///   candidate has a reaction if and only if X is empty: t* < 0, though within the tolerance.
struct RelativeInterior {
  support::IndexSet loaded;  ///< r_i != 0 somewhere on X
  support::IndexSet moved;   ///< u_ni > 0 somewhere on X
};

/// Solves node programs with scalar type Real, in sequence, with one cone per candidate. A result
/// depends on the arguments of solve() only, to the last bit.
template <int D, class Real>
class PlainSolver {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

  /// @param compliance F, Dm x Dm, scaled as that of NodeSolver
  /// @param friction mu, m numbers, each 0 or 1e-6 to 1e6
  /// @param error e: |F_ij - F*_ij| <= e sqrt(F*_ii F*_jj) for the true F*
  /// @param motions of an unconstrained body  @param loads number of loads, the last candidates
  PlainSolver(Matrix compliance, std::span<const double> friction, Tolerances tolerances,
              double error, Motions<Real> motions = {}, int loads = 0);

  /// Sets the stop test: every solve then throws support::Stopped soon after it becomes true.
  void end_when(support::Stop stop) { stop_ = std::move(stop); }

  /// Sets mu for the next calls of solve().
  void set_friction(std::span<const double> friction) {
    friction_.assign(friction.begin(), friction.end());
  }

  /// Bounds the node; see NodeSolver::solve. @pre not all candidates are separated or ignored
  ConicResult solve(const support::IndexSet& contact, const support::IndexSet& separated,
                    StopEarly stop, const support::IndexSet& ignored = {});

  /// Candidates with a reaction or a gap at a point of the relative interior of X. The points of
  /// the iteration tend to such a point as the bracket closes: reactions and gaps that vanish there
  /// decrease with the width of the bracket or its root, others stay. Nothing if this is
  /// numerically undecided for some candidate, or if t* is not zero up to the tolerance. reaction()
  /// is the point.
  std::optional<RelativeInterior> relative_interior(const support::IndexSet& contact,
                                                    const support::IndexSet& separated,
                                                    const support::IndexSet& ignored = {});

  /// r, Dm, of the point that proves the lower bound.
  const Vector& reaction() const { return reaction_; }
  /// u = F r + G alpha.
  Vector displacement() const;
  /// alpha of an unconstrained body: one number for each mode with a normal part.
  const Vector& motion() const { return motion_; }
  /// y, m, and beta of the p modes of an unconstrained body, that prove the upper bound.
  const Vector& multipliers() const { return multipliers_; }

 private:
  using Cone = ConePoint<D, Real>;

  void select(const support::IndexSet& contact, const support::IndexSet& separated,
              const support::IndexSet& ignored);
  Matrix normal_motions(const std::vector<int>& candidates) const;  // H of these
  void choose_motions();
  void choose_equations();
  Vector by_rows(const Vector& all) const;  // entries of the rows of A, of m + p numbers
  Vector multipliers_of_all() const;        // y, m + p numbers
  void start();
  ConicResult nothing_known();
  NodeSets sets() const { return {cones_, gap_rows_, contact_rows_, contact_}; }
  Real level(const Real& value) const { return (Real(1) - value) / omega_; }
  Vector reaction_of(const std::vector<Cone>& x) const;

  bool refresh_dual(const Vector& y);
  bool factorise();
  Vector solved(Vector right_side) const;  // M^-1 right_side
  bool solve_for_motions();
  Vector balance(Vector& solution) const;  // see InteriorPoint::balance
  Vector normal_displacements(const Vector& r, const Vector& motion) const;
  Vector products(const std::vector<Cone>& points) const;    // A x
  Cone transposed(std::size_t cone, const Vector& y) const;  // (A'y) of a cone
  std::vector<Cone> shifted(const std::vector<Cone>& x, const Vector& weights) const;
  struct Step {
    std::vector<Cone> x, z;  // scaled
    Vector v, y;             // scaled
    Real inverse_primal_length, inverse_dual_length;
  };
  Step direction(const Vector& dy, const std::vector<Cone>& q, const Vector& q_rows) const;
  bool advance();
  /// Point stored as reaction(): the one that proves the best bound, or that of the last iteration.
  enum class Keep { best, latest };
  void prove_lower(ConicResult& answer, Keep keep);
  /// True if the motion of the last iterate grows without bound because it displaces candidates
  /// that are not pressed back. These have no row from the next select() on, since u_nj >= t does
  /// not constrain them.
  bool lift_off();
  Vector lifting_motion(const Vector& r, Vector motion) const;
  void prove_upper(ConicResult& answer);
  void prove_upper_unconstrained(ConicResult& answer);
  void prove_contradiction(ConicResult& answer);
  void take_sizes(std::vector<double>& sizes) const;
  /// An iterate on the way to a degenerate solution.
  struct Snapshot {
    double width;               // of the bracket
    std::vector<double> sizes;  // see take_sizes
    Vector reaction, motion;
  };
  double violation() const;
  double reaction_size() const;  // Q of docs/theory/wedged.md

  Matrix compliance_;
  Motions<Real> motions_;     // G
  Matrix normal_compliance_;  // rows (n, i) of F, then G': (m + p) x Dm
  std::vector<double> friction_;
  Tolerances tolerances_;
  Bounds<D, Real> bounds_;
  int loads_;
  Vector reaction_, motion_, multipliers_;

  support::Stop stop_;

  // The node.
  support::IndexSet contact_;
  std::vector<int> cones_, gap_rows_, contact_rows_;
  support::IndexSet lifted_;     // gap rows that A omits
  Vector lift_;                  // a motion that displaces these and no row of A
  std::vector<int> rows_;        // candidates with a row: the first rows of A
  Matrix equations_;             // T, p x p': the further rows are T'G'r = 0
  std::vector<bool> slack_;      // of all rows: true if it has a slack
  std::vector<Matrix> columns_;  // of A: rows x D for each cone
  Matrix free_motions_;          // basis of the modes visible in these rows, by columns
  Matrix free_columns_;          // H times this basis, by rows
  typename Bounds<D, Real>::MotionCost motion_cost_;
  Vector right_side_;  // b
  Real omega_ = 0;     // sigma

  // The iterate.
  std::vector<Cone> x_, z_;
  Vector v_, y_;  // by rows
  Real best_value_ = 0;
  std::vector<NesterovToddScaling<D, Real>> scaling_;
  Vector w_, lambda_;              // of the rows: sqrt(v / y) and sqrt(v y)
  Vector primal_residual_;         // b - A x + v
  Vector predictor_, correction_;  // M^-1 of b and of the residual
  Vector projected_motion_;        // in this basis, belongs to correction_
  Matrix factor_;                  // of M, lower triangle
  Matrix moved_;                   // M^-1 H
  Eigen::LLT<Matrix> schur_;       // of H'M^-1 H
  Real complementarity_ = 0;
};

extern template class PlainSolver<2, long double>;
extern template class PlainSolver<3, long double>;
extern template class PlainSolver<2, numbers::Precise>;
extern template class PlainSolver<3, numbers::Precise>;

}  // namespace kusabi::conic
