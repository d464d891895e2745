// The bound of one node of the tree of sign patterns (the wedged paper, Algorithm 5.1 step 3), with
// evidence: a feasible reaction proves t* from below, a dual vector proves it from above.
//
// The tree asks only for the sign of t*, so the iteration stops as soon as one side has proved it.
// Neither side rounds: an answer that cannot be told from zero is `marginal`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "nodes/conic/interior_point.hpp"
#include "nodes/conic/node_program.hpp"

namespace kusabi::conic {

/// What is proved about t*: positive, negative, or neither.
enum class Sign { alive, dead, marginal };

/// All in the scaled units of the compliance (mean diagonal of its normal block 1).
struct Tolerances {
  double sign = 1e-7;   ///< |t*| below this is marginal: well above the rounding of the two bounds
  double value = 1e-8;  ///< width of the bracket, relative to max(1, |t*|), that ends the iteration
  int iterations = 60;  ///< ordinary nodes need 10 to 20
};

/// Whether to stop once the sign is proved; otherwise the iteration goes on to the full accuracy
/// of the value. A marginal node stops early only when both are set.
struct StopEarly {
  bool when_dead = true;
  bool when_alive = true;
};

/// The bracket lower <= t* <= upper and what is concluded from it.
struct Answer {
  Sign sign = Sign::marginal;
  double lower = 0;            ///< proved by reaction(); minus infinity without one
  double upper = 0;            ///< proved by multipliers(); minus infinity when R is everything
  int iterations = 0;          ///< factorisations
  double primal_residual = 0;  ///< largest |u_n| on U, or |sum_i r_n - 1|, at reaction()
  double gap = 0;              ///< upper - lower
  bool has_point = false;      ///< reaction() is feasible and gives `lower`
};

/// Solves the node programs of one contact problem, one node after another. Owns its workspace and
/// allocates nothing after construction, so each rank has one. A result depends on the arguments of
/// solve() only, to the last bit. The references below hold until the next solve().
template <int D>
class NodeSolver {
 public:
  /// @param compliance F, Dm x Dm, symmetric positive definite, ordered by candidate and in it
  ///        (n, t1[, t2]), scaled to mean diagonal 1 of its normal block
  /// @param friction mu, m numbers > 0, m <= 64
  /// @throws std::invalid_argument when the sizes disagree or a number is out of range
  NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
             Tolerances tolerances = {});

  /// The same with several cones for a candidate (NodeProgram): reactions and displacements are
  /// then those of the cones.
  NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
             std::vector<int> owners, Tolerances tolerances = {});

  /// From the next solve() on, mu is this. See NodeProgram.
  void set_friction(std::span<const double> friction) { program_.set_friction(friction); }

  /// Bounds the node with the candidates `contact` in U and `separated` in R (bit i = candidate i).
  /// @throws std::invalid_argument when the sets overlap or name a candidate that does not exist
  Answer solve(std::uint64_t contact, std::uint64_t separated, StopEarly stop = {});

  /// r, Dm: zero on R, sum of the normal parts 1, u_n = 0 on U. The point that proves `lower`;
  /// when there is none, the last projection, which may serve for branching; zero if R is
  /// everything.
  const Eigen::VectorXd& reaction() const { return reaction_; }
  /// u = F r of reaction(), Dm.
  const Eigen::VectorXd& displacement() const { return displacement_; }
  /// y, m: proves `upper` by weak duality; y_j >= 0 for j not in U; zero if R is everything.
  const Eigen::VectorXd& multipliers() const { return multipliers_; }

 private:
  NodeSolver(NodeProgram<D> program, Tolerances tolerances);
  void iterate(Answer& answer, StopEarly stop);
  bool settled(const Answer& answer, StopEarly stop) const;
  void raise_lower(Answer& answer);
  void sink_upper(Answer& answer);

  NodeProgram<D> program_;
  InteriorPoint<D> iteration_;
  Tolerances tolerances_;
  Eigen::VectorXd reaction_, displacement_, multipliers_, trial_;
};

extern template class NodeSolver<2>;
extern template class NodeSolver<3>;

}  // namespace kusabi::conic
