// The bound of one node of the tree of sign patterns (the wedged paper, Algorithm 5.1 step 3), with
// evidence: a feasible reaction proves t* from below, a dual vector proves it from above.
//
// The tree asks only for the sign of t*, so the iteration stops as soon as one side has proved it.
// Both sides hold in spite of rounding (solvers/conic/bounds.hpp); what doubles leave open is for
// the solvers with more digits (solvers/conic/plain_solver.hpp).
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

/// Solves the node programs of one contact problem, one node after another. Owns its workspace and
/// allocates nothing after construction, so each rank has one. A result depends on the arguments of
/// solve() only, to the last bit. The references below hold until the next solve().
template <int D>
class NodeSolver {
 public:
  /// @param compliance F, Dm x Dm, symmetric positive definite, ordered by candidate and in it
  ///        (n, t1[, t2]), scaled to mean diagonal 1 of its normal block
  /// @param friction mu, m numbers, each 0 or 1e-6 to 1e6
  /// @param error e: |F_ij - F*_ij| <= e sqrt(F*_ii F*_jj) for the F* that is meant; 0 if it is F
  /// @throws std::invalid_argument when the sizes disagree or a number is out of range
  NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
             Tolerances tolerances = {}, double error = 0);

  /// The same with several cones for a candidate (NodeProgram): reactions and displacements are
  /// then those of the cones.
  /// @param motions of a loose body
  NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
             std::vector<int> owners, Tolerances tolerances = {}, double error = 0,
             const Motions<double>& motions = {});

  /// From now on there is room for so many cuts; at first there is none.
  void make_room(int most_cuts);

  /// From now on solve() throws support::Stopped soon after an end is asked for. Only programs with
  /// many rows ask, once an iteration.
  void end_when(support::Stop stop) { stop_ = std::move(stop); }

  /// From the next solve() on, mu is this. See NodeProgram.
  void set_friction(std::span<const double> friction) { program_.set_friction(friction); }

  /// Bounds the node with the candidates `contact` in U and `separated` in R; those of `ignored`
  /// have r = 0 and u_n free.
  /// @param cuts further rows
  /// @throws std::invalid_argument when the sets overlap or name a candidate that does not exist
  Answer solve(const support::IndexSet& contact, const support::IndexSet& separated,
               StopEarly stop = {}, const support::IndexSet& ignored = {},
               std::span<const Cut> cuts = {});

  /// r, Dm: zero on R, sum of the normal parts 1, u_n = 0 on U. The point that proves `lower`;
  /// when there is none, the last projection, which may serve for branching; zero if R is
  /// everything.
  const Eigen::VectorXd& reaction() const { return reaction_; }
  /// u = F r + G alpha of reaction() and motion(), Dm.
  const Eigen::VectorXd& displacement() const { return displacement_; }
  /// alpha of a loose body: one number for each motion that lifts.
  const Eigen::VectorXd& motion() const { return motion_; }
  /// From the centre of the relaxation to its faces, by candidate; zero for those that have a sign.
  /// Empty if the centre is not found. Call after a solve() that was stopped when alive, once.
  /// @pre a cone for each candidate, and no motions
  std::span<const FaceDistances> face_distances();
  /// y, m, and beta of the p motions of a loose body: proves `upper` (solvers/conic/bounds.hpp);
  /// y_j >= 0 for j not in U; zero if R is everything.
  const Eigen::VectorXd& multipliers() const { return multipliers_; }
  /// Of a cut of the last node, >= 0.
  double cut_multiplier(std::size_t cut) const {
    return best_[program_.first_cut() + static_cast<Eigen::Index>(cut)];
  }
  /// w of the last node: what multipliers() pull at each cone, and what those of cuts add.
  const Eigen::VectorXd& pull() { return program_.pull(best_); }
  /// What the left side of a cut of the last node can be at most, for sum_k r_nk = 1 and wherever
  /// t >= 0 is possible: proved by the same multipliers. Infinity if these say nothing, minus
  /// infinity if they leave nothing whatever the cut.
  double most_of(std::size_t cut);

 private:
  NodeSolver(NodeProgram<D> program, Tolerances tolerances, double error);
  void iterate(Answer& answer, StopEarly stop);
  void raise_lower(Answer& answer);
  void sink_upper(Answer& answer);
  void prove_upper(Answer& answer);
  void prove_upper_loose(Answer& answer);

  NodeProgram<D> program_;
  InteriorPoint<D> iteration_;
  Bounds<D, double> bounds_;
  Tolerances tolerances_;
  Eigen::VectorXd reaction_, displacement_, motion_, multipliers_, trial_;
  typename Bounds<D, double>::MotionCost motion_cost_;
  std::vector<FaceDistances> face_distances_;
  support::Stop stop_;
  Eigen::VectorXd best_;   // of the multipliers so far, padded
  double best_value_ = 0;  // of t*, as it was computed
  bool proved_ = true;     // whether it is in the answer
};

extern template class NodeSolver<2>;
extern template class NodeSolver<3>;

}  // namespace kusabi::conic
