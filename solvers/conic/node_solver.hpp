// NodeSolver: bound of one node of the tree of sign patterns (the wedged paper, Algorithm 5.1 step
// 3), with evidence: a feasible reaction proves a lower bound of t*, a dual vector an upper bound.
//
// The tree needs only the sign of t*, so the iteration stops as soon as one side proves it. Both
// bounds include rounding errors (solvers/conic/bounds.hpp). Nodes that are numerically undecided
// in doubles are examined and solved with longer numbers (nodes/wedged/relaxation/contact_solver.hpp).
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "solvers/conic/answer.hpp"
#include "solvers/conic/bounds.hpp"
#include "solvers/conic/interior_point.hpp"
#include "solvers/conic/iteration_rules.hpp"
#include "solvers/conic/node_program.hpp"
#include "support/stop.hpp"

namespace kusabi::conic {

/// Candidates with a reaction, and those with a gap, at a point of the relative interior of the
/// solutions of a degenerate node,
///
///   X = {r : u_n = 0 on U, r = 0 on R, u_n >= 0, r in the friction cones, sum r_n = 1}.
///
/// If no candidate has a reaction, X is empty: t* is negative, though within the tolerance.
struct RelativeInterior {
  support::IndexSet loaded;  ///< r_i != 0 somewhere on X
  support::IndexSet moved;   ///< u_ni > 0 somewhere on X
};

/// Solves the node programs of one contact problem in sequence, in doubles, long doubles or numbers
/// of 104 bits. Owns its workspace; without rigid-body modes, doubles allocate nothing later; each rank
/// has one. A result depends on the arguments of solve() only, to the last bit. The references
/// below are valid until the next solve().
template <int D, class Real = double>
class NodeSolver {
 public:
  using Vector = VectorOf<Real>;
  using Matrix = MatrixOf<Real>;

  /// @param compliance F, Dm x Dm, symmetric positive definite, ordered by candidate and within it
  ///        (n, t1[, t2]), scaled to mean diagonal 1 of its normal block
  /// @param friction mu, m numbers, each 0 or 1e-6 to 1e6
  /// @param error e: |F_ij - F*_ij| <= e sqrt(F*_ii F*_jj) for the true F*; 0 if F is exact
  /// @throws std::invalid_argument if the sizes disagree or a number is out of range
  NodeSolver(const Matrix& compliance, std::span<const double> friction, Tolerances tolerances = {},
             double error = 0);

  /// With several cones per candidate (NodeProgram): reactions and displacements are those of the
  /// cones.
  /// @param motions of an unconstrained body  @param loads number of loads, the last candidates
  NodeSolver(const Matrix& compliance, std::span<const double> friction, std::vector<int> owners,
             Tolerances tolerances = {}, double error = 0, const Motions<Real>& motions = {},
             int loads = 0);

  /// Allocates room for cuts; initially there is none.
  void make_room(int max_cuts);

  /// Sets the stop test: solve() then throws support::Stopped soon after it becomes true. It is
  /// evaluated once an iteration, in programs with many rows only.
  void end_when(support::Stop stop) { stop_ = std::move(stop); }

  /// Sets mu for the next calls of solve(). See NodeProgram.
  void set_friction(std::span<const double> friction) { program_.set_friction(friction); }

  /// Bounds the node with the candidates `contact` in U and `separated` in R; those of `ignored`
  /// have r = 0 and u_n free.
  /// @param cuts further rows
  /// @throws std::invalid_argument if the sets overlap or contain a candidate that does not exist
  ConicResult solve(const support::IndexSet& contact, const support::IndexSet& separated,
                    StopEarly stop = {}, const support::IndexSet& ignored = {},
                    std::span<const Cut> cuts = {});

  /// The same, from the last iterate of a solver with shorter numbers for the same node.
  template <class Shorter>
  ConicResult solve_from(const NodeSolver<D, Shorter>& start, const support::IndexSet& contact,
                         const support::IndexSet& separated, StopEarly stop,
                         const support::IndexSet& ignored);

  /// Bounds of the last node, without cuts, from the point and the multipliers of its iteration, whose
  /// equations are solved with longer numbers. The bounds of a point include the rounding of all its
  /// displacements: often they prove nothing where the point itself is accurate enough. Nothing is
  /// proved if no iteration has come to a point.
  /// @param judge solver of the same problem, which receives what proves the bounds
  template <class Longer>
  ConicResult examine_with(NodeSolver<D, Longer>& judge);

  /// Candidates with a reaction or a gap at a point of the relative interior of X. The points of
  /// the iteration tend to such a point as the bracket closes: reactions and gaps that vanish there
  /// decrease with the width of the bracket or its root, others stay. Nothing if this is
  /// numerically undecided for some candidate, or if t* is not zero up to the tolerance. reaction()
  /// is the point. With 104 bits only.
  std::optional<RelativeInterior> relative_interior(const support::IndexSet& contact,
                                                    const support::IndexSet& separated,
                                                    const support::IndexSet& ignored = {});

  /// r, Dm: zero on R, sum of the normal parts 1, u_n = 0 on U. The point that proves `lower`; if
  /// there is none, the last projection, which may serve for branching; zero if R contains all
  /// candidates.
  const Vector& reaction() const { return reaction_; }
  /// u = F r + G alpha of reaction() and motion(), Dm.
  const Vector& displacement() const { return displacement_; }
  /// alpha of an unconstrained body: one number for each mode with a normal part.
  const Vector& motion() const { return motion_; }
  /// Distances from a point inside the relaxation to its faces, by candidate; zero for candidates
  /// with a sign. The point is the centre in the plane, and the last one of the iteration in space.
  /// Empty if the centre is not found. Call at most once, after a solve() with an
  /// early stop at a positive sign.
  /// @pre one cone per candidate, and no rigid-body modes
  std::span<const FaceDistances> face_distances();
  /// y, m, and beta of the p modes of an unconstrained body: proves `upper`
  /// (solvers/conic/bounds.hpp); y_j >= 0 for j not in U; zero if R contains all candidates.
  const Vector& multipliers() const { return multipliers_; }
  /// Multiplier of a cut of the last node, >= 0.
  Real cut_multiplier(std::size_t cut) const {
    return best_[program_.first_cut() + static_cast<Eigen::Index>(cut)];
  }
  /// w of the last node: product of multipliers() with F at each cone, with the contribution of the
  /// cuts.
  const Vector& pull() { return program_.pull(best_); }
  /// Upper bound of the left side of a cut of the last node, for sum_k r_nk = 1 and t >= 0, proved
  /// by the same multipliers. Infinity if they prove nothing, minus infinity if they exclude t >= 0
  /// for any cut.
  double max_of(std::size_t cut);

 private:
  template <int, class>
  friend class NodeSolver;

  NodeSolver(NodeProgram<D, Real> program, Tolerances tolerances, double error);
  template <class Longer>
  void examine_point(NodeSolver<D, Longer>& judge, ConicResult& answer);
  template <class Longer>
  void examine_multipliers(NodeSolver<D, Longer>& judge, ConicResult& answer) const;
  // Selects the node and prepares its bounds; false if no reaction has a sum of one.
  bool begin(const support::IndexSet& contact, const support::IndexSet& separated,
             const support::IndexSet& ignored, std::span<const Cut> cuts);
  ConicResult nothing_known();
  void finish(ConicResult& answer);
  // Bound that has just been examined.
  enum class ExaminedBound { upper, lower };
  // Point stored as reaction(): the one that proves the best bound, or that of the last iteration.
  enum class Keep { best, latest };
  // Iterates until `ends(side)`. Returns false if the normal equations are singular.
  template <class Ends>
  bool iterate(ConicResult& answer, Keep keep, Ends ends);
  void raise_lower(ConicResult& answer, Keep keep);
  void decrease_upper(ConicResult& answer);
  void prove_upper(ConicResult& answer);
  void take_multipliers(ConicResult& answer, const Vector& y);
  void take_equilibrated(ConicResult& answer, const Vector& y);
  void prove_contradiction(ConicResult& answer);
  // True if the motion of the last iterate grows without bound because it displaces candidates that
  // are not pressed back. These have no row from now on, since u_nj >= t does not constrain them.
  bool lift_off();
  Vector lifting_motion(const Vector& r, Vector motion);
  [[nodiscard]] Vector lifts(const Vector& motion) const {
    return program_.normal_motions() * motion;
  }

  // Of the search for the relative interior.
  struct Snapshot {
    double width;               // of the bracket
    std::vector<double> sizes;  // of reactions and gaps
    Vector reaction, motion;
  };
  std::vector<double> sizes();
  double violation();
  [[nodiscard]] double reaction_size() const;              // Q of docs/theory/wedged.md
  [[nodiscard]] double own_root(Eigen::Index row) const {  // R
    return std::sqrt(numbers::rounded(program_.compliance()(row, row)));
  }

  NodeProgram<D, Real> program_;
  InteriorPoint<D, Real> iteration_;
  Bounds<D, Real> bounds_;
  Tolerances tolerances_;
  Vector reaction_, displacement_, motion_, multipliers_, trial_, trial_motion_;
  typename Bounds<D, Real>::MotionCost motion_cost_;
  std::vector<FaceDistances> face_distances_;
  support::Stop stop_;
  Vector best_;               // of the best multipliers so far, padded
  Real best_value_ = 0;       // upper bound of t*, as computed
  bool proved_ = true;        // true if the bound is in the result
  support::IndexSet lifted_;  // gap rows that are omitted
  Vector lift_;               // a motion that displaces these and no row
};

template <int D, class Real>
template <class Ends>
bool NodeSolver<D, Real>::iterate(ConicResult& answer, Keep keep, Ends ends) {
  const int maximum = extended<Real> ? max_extended_iterations : tolerances_.iterations;
  for (int iteration = 0;; ++iteration) {
    decrease_upper(answer);
    if (ends(ExaminedBound::upper) || iteration == maximum) return true;
    ++answer.iterations;
    if (extended<Real> || program_.rows() >= rows_that_take_long)
      support::throw_if_requested(stop_);
    if (!iteration_.factorise(program_)) return false;
    raise_lower(answer, keep);
    if (ends(ExaminedBound::lower) || !iteration_.advance(program_)) return true;
  }
}

}  // namespace kusabi::conic
