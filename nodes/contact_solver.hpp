// The cone solver of a wedged problem, in the plane or in space: every tree over its sign patterns
// has one.
//
// The compliance is scaled so that the mean diagonal of its normal part F_nn is 1: t compares
// reactions with displacements, so its size (not its sign) hangs on the units.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include <Eigen/Core>

#include "nodes/conic/node_solver.hpp"
#include "problems/wedged_problem.hpp"

namespace kusabi::nodes {

/// The candidates that a configuration in the relative interior of a tie loads and moves: what is
/// zero there is zero in all configurations of the node.
struct RelativeInterior {
  std::uint64_t loaded = 0;  ///< r_n > 0
  std::uint64_t moved = 0;   ///< u_n > 0
};

/// conic::NodeSolver of the problem's dimension. Allocates nothing after construction; each rank
/// has its own. The references hold until the next solve().
class ContactSolver {
 public:
  /// @param friction mu of each contact candidate, m numbers > 0
  /// @throws std::invalid_argument if the sizes do not fit or a number is out of range
  ContactSolver(const problems::WedgedProblem& problem, std::span<const double> friction,
                conic::Tolerances tolerances);

  /// From the next solve() on, mu is this.
  void set_friction(std::span<const double> friction);

  /// Bounds the node with the candidates `contact` in U and `separated` in R.
  /// @param ignored candidates that have no reaction and of which no displacement is asked
  conic::Answer solve(std::uint64_t contact, std::uint64_t separated, conic::StopEarly stop,
                      std::uint64_t ignored = 0);

  /// Of a node that is marginal with a bracket within the tolerance. reaction() and displacement()
  /// are then a point of it. Nothing if zero cannot be told from nonzero.
  std::optional<RelativeInterior> relative_interior(std::uint64_t contact,
                                                    std::uint64_t separated);

  /// r, dm; see conic::NodeSolver.
  [[nodiscard]] const Eigen::VectorXd& reaction() const;
  /// u = F r with the scaled F, dm.
  [[nodiscard]] const Eigen::VectorXd& displacement() const;
  /// y, m.
  [[nodiscard]] const Eigen::VectorXd& multipliers() const;

  [[nodiscard]] double normal_reaction(int candidate) const {
    return reaction()[normal(candidate)];
  }
  [[nodiscard]] double normal_displacement(int candidate) const {
    return displacement()[normal(candidate)];
  }
  /// u_n r_n: by how much the candidate violates complementarity.
  [[nodiscard]] double violation(int candidate) const {
    return normal_displacement(candidate) * normal_reaction(candidate);
  }

  [[nodiscard]] int dimension() const { return dimension_; }
  /// By what the compliance is divided, length/force.
  [[nodiscard]] double unit() const { return unit_; }
  /// Where the normal part of a candidate stands in r and u.
  [[nodiscard]] Eigen::Index normal(int candidate) const {
    return Eigen::Index{dimension_} * candidate;
  }

 private:
  int dimension_;
  double unit_;
  std::variant<conic::NodeSolver<2>, conic::NodeSolver<3>> solver_;
};

}  // namespace kusabi::nodes
