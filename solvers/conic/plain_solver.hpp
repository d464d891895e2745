// The solver of node programs once more, with more digits: what doubles leave open is decided here.
//
// The same standard form, iteration and proofs as in node_program.hpp, interior_point.hpp and
// node_solver.hpp, written for clarity and not for speed, on any kind of number. It is the upper
// rungs of a ladder: long double, then 104 bits (nodes/wedged/contact_solver.hpp).
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

/// Which candidates have a reaction, and which a gap, at a point of the relative interior of the
/// solutions of a tie,
///   X = {r : u_n = 0 on U, r = 0 on R, u_n >= 0, r in the friction cones, sum r_n = 1}.
/// No candidate is loaded if and only if X is empty: t* < 0, though not by more than the
/// tolerance.
struct RelativeInterior {
  support::IndexSet loaded;  ///< r_i != 0 somewhere on X
  support::IndexSet moved;   ///< u_ni > 0 somewhere on X
};

/// Solves node programs on numbers of kind Real, one after another, a candidate a cone. A result
/// depends on the arguments of solve() only, to the last bit.
template <int D, class Real>
class PlainSolver {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

  /// @param compliance F, Dm x Dm, scaled as that of NodeSolver
  /// @param friction mu, m numbers, each 0 or 1e-6 to 1e6
  /// @param error e: |F_ij - F*_ij| <= e sqrt(F*_ii F*_jj) for the F* that is meant
  /// @param motions of a loose body
  PlainSolver(Matrix compliance, std::span<const double> friction, Tolerances tolerances,
              double error, Motions<Real> motions = {});

  /// From now on whatever solves throws support::Stopped soon after an end is asked for.
  void end_when(support::Stop stop) { stop_ = std::move(stop); }

  /// From the next solve() on, mu is this.
  void set_friction(std::span<const double> friction) {
    friction_.assign(friction.begin(), friction.end());
  }

  /// Bounds the node; see NodeSolver::solve. No node has all candidates separated or ignored.
  Answer solve(const support::IndexSet& contact, const support::IndexSet& separated, StopEarly stop,
               const support::IndexSet& ignored = {});

  /// The candidates that are loaded or moved at a point of the relative interior of X. The points
  /// of the iteration tend to such a point as the bracket closes: reactions and gaps that vanish
  /// there fall with the width of the bracket or its root, others stay. Nothing if it cannot be
  /// told of each whether it vanishes, or if t* is not zero up to the tolerance. reaction() is the
  /// point.
  std::optional<RelativeInterior> relative_interior(const support::IndexSet& contact,
                                                    const support::IndexSet& separated,
                                                    const support::IndexSet& ignored = {});

  /// r, Dm, of the point that proves the lower bound.
  const Vector& reaction() const { return reaction_; }
  /// u = F r + G alpha.
  Vector displacement() const;
  /// alpha of a loose body: one number for each motion that lifts.
  const Vector& motion() const { return motion_; }
  /// y, m, and beta of the p motions of a loose body, that prove the upper bound.
  const Vector& multipliers() const { return multipliers_; }

 private:
  using Cone = Point<D, Real>;

  void select(const support::IndexSet& contact, const support::IndexSet& separated,
              const support::IndexSet& ignored);
  Matrix normal_motions(const std::vector<int>& candidates) const;  // H of these
  void choose_motions();
  void choose_equations();
  Vector by_rows(const Vector& all) const;  // of m + p numbers, those of the rows of A
  Vector multipliers_of_all() const;        // y, m + p numbers
  void start();
  Answer nothing_known();
  NodeSets sets() const { return {cones_, gap_rows_, contact_rows_, contact_}; }
  Real level(const Real& value) const { return (Real(1) - value) / omega_; }
  Vector reaction_of(const std::vector<Cone>& x) const;

  bool refresh_dual(const Vector& y);
  bool factorise();
  Vector solved(Vector right_side) const;  // M^-1 right_side
  bool solve_for_motions();
  Vector balance(Vector& solution) const;  // see InteriorPoint
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
  /// Which point becomes reaction(): the one that proves the best bound, or that of the last
  /// iteration.
  enum class Keep { best, latest };
  void prove_lower(Answer& answer, Keep keep);
  /// Whether the motion of the last iterate runs away because it lifts candidates that nothing
  /// presses back. These have no row from the next select() on: u_nj >= t says nothing of them.
  bool lift_off();
  Vector lifting_motion(const Vector& r, Vector motion) const;
  void prove_upper(Answer& answer);
  void prove_upper_loose(Answer& answer);
  void prove_contradiction(Answer& answer);
  void take_sizes(std::vector<double>& sizes) const;
  /// An iterate on the way to a tie.
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
  Vector reaction_, motion_, multipliers_;

  support::Stop stop_;

  // The node.
  support::IndexSet contact_;
  std::vector<int> cones_, gap_rows_, contact_rows_;
  support::IndexSet lifted_;     // gap rows that A is without
  Vector lift_;                  // a motion that lifts these and moves no row of A
  std::vector<int> rows_;        // the candidates with a row: the first rows of A
  Matrix equations_;             // T, p x p': the others are T'G'r = 0
  std::vector<bool> slack_;      // of all rows: whether it has one
  std::vector<Matrix> columns_;  // of A: rows x D for each cone
  Matrix free_motions_;          // a basis of those that these rows see, by columns
  Matrix free_columns_;          // H times this basis, by rows
  typename Bounds<D, Real>::MotionCost motion_cost_;
  Vector right_side_;  // b
  Real omega_ = 0;     // sigma

  // The iterate.
  std::vector<Cone> x_, z_;
  Vector v_, y_;  // by rows
  Real best_value_ = 0;
  std::vector<Scaling<D, Real>> scaling_;
  Vector w_, lambda_;              // of the rows: sqrt(v / y) and sqrt(v y)
  Vector primal_residual_;         // b - A x + v
  Vector predictor_, correction_;  // M^-1 of b and of the residual
  Vector projected_motion_;        // in this basis, what goes with correction_
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
