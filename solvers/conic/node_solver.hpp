// NodeSolver: bound of one node of the tree of sign patterns (the wedged paper, Algorithm 5.1 step
// 3), with evidence: a feasible reaction proves a lower bound of t*, a dual vector an upper bound.
//
// The tree needs only the sign of t*, so the iteration stops as soon as one side proves it. Both
// bounds include rounding errors (solvers/conic/bounds.hpp). Nodes that are numerically undecided
// in doubles escalate to extended precision (solvers/conic/plain_solver.hpp).
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "solvers/conic/answer.hpp"
#include "solvers/conic/interior_point.hpp"
#include "solvers/conic/node_program.hpp"
#include "support/stop.hpp"

namespace kusabi::conic {

/// Solves the node programs of one contact problem in sequence. Owns its workspace and allocates
/// nothing after construction; each rank has one. A result depends on the arguments of solve()
/// only, to the last bit. The references below are valid until the next solve().
template <int D>
class NodeSolver {
 public:
  /// @param compliance F, Dm x Dm, symmetric positive definite, ordered by candidate and within it
  ///        (n, t1[, t2]), scaled to mean diagonal 1 of its normal block
  /// @param friction mu, m numbers, each 0 or 1e-6 to 1e6
  /// @param error e: |F_ij - F*_ij| <= e sqrt(F*_ii F*_jj) for the true F*; 0 if F is exact
  /// @throws std::invalid_argument if the sizes disagree or a number is out of range
  NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
             Tolerances tolerances = {}, double error = 0);

  /// With several cones per candidate (NodeProgram): reactions and displacements are those of the
  /// cones.
  /// @param motions of an unconstrained body  @param loads number of loads, the last candidates
  NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
             std::vector<int> owners, Tolerances tolerances = {}, double error = 0,
             const Motions<double>& motions = {}, int loads = 0);

  /// Allocates room for cuts; initially there is none.
  void make_room(int most_cuts);

  /// Sets the stop test: solve() then throws support::Stopped soon after it becomes true. Only
  /// programs with many rows ask, once an iteration.
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

  /// r, Dm: zero on R, sum of the normal parts 1, u_n = 0 on U. The point that proves `lower`; if
  /// there is none, the last projection, which may serve for branching; zero if R contains all
  /// candidates.
  const Eigen::VectorXd& reaction() const { return reaction_; }
  /// u = F r + G alpha of reaction() and motion(), Dm.
  const Eigen::VectorXd& displacement() const { return displacement_; }
  /// alpha of an unconstrained body: one number for each mode with a normal part.
  const Eigen::VectorXd& motion() const { return motion_; }
  /// Distances from the centre of the relaxation to its faces, by candidate; zero for candidates
  /// with a sign. Empty if the centre is not found. Call at most once, after a solve() with an
  /// early stop at a positive sign.
  /// @pre one cone per candidate, and no rigid-body modes
  std::span<const FaceDistances> face_distances();
  /// y, m, and beta of the p modes of an unconstrained body: proves `upper`
  /// (solvers/conic/bounds.hpp); y_j >= 0 for j not in U; zero if R contains all candidates.
  const Eigen::VectorXd& multipliers() const { return multipliers_; }
  /// Multiplier of a cut of the last node, >= 0.
  double cut_multiplier(std::size_t cut) const {
    return best_[program_.first_cut() + static_cast<Eigen::Index>(cut)];
  }
  /// w of the last node: product of multipliers() with F at each cone, with the contribution of the
  /// cuts.
  const Eigen::VectorXd& pull() { return program_.pull(best_); }
  /// Upper bound of the left side of a cut of the last node, for sum_k r_nk = 1 and t >= 0, proved
  /// by the same multipliers. Infinity if they prove nothing, minus infinity if they exclude t >= 0
  /// for any cut.
  double most_of(std::size_t cut);

 private:
  NodeSolver(NodeProgram<D> program, Tolerances tolerances, double error);
  void iterate(ConicResult& answer, StopEarly stop);
  void raise_lower(ConicResult& answer);
  void sink_upper(ConicResult& answer);
  void prove_upper(ConicResult& answer);
  void prove_upper_unconstrained(ConicResult& answer);

  NodeProgram<D> program_;
  InteriorPoint<D> iteration_;
  Bounds<D, double> bounds_;
  Tolerances tolerances_;
  Eigen::VectorXd reaction_, displacement_, motion_, multipliers_, trial_;
  typename Bounds<D, double>::MotionCost motion_cost_;
  std::vector<FaceDistances> face_distances_;
  support::Stop stop_;
  Eigen::VectorXd best_;   // of the best multipliers so far, padded
  double best_value_ = 0;  // upper bound of t*, as computed
  bool proved_ = true;     // true if the bound is in the result
};

extern template class NodeSolver<2>;
extern template class NodeSolver<3>;

}  // namespace kusabi::conic
