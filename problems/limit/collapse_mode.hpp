// A collapse mode for a person: which nodes move and how, which members yield, whether the truss
// sways.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "problems/limit/limit_problem.hpp"

namespace kusabi::problems {

/// What moves or yields does so by more than this part of the largest velocity: basic solutions
/// carry rounding of 1e-12 or so, and no mode that matters has velocities so far apart.
inline constexpr double visible_motion = 1e-7;

struct NodeVelocity {
  int node;
  Eigen::VectorXd velocity;  ///< d; with f_R^T u = 1, per unit of force
};

struct YieldingMember {
  int member;
  double elongation;  ///< rate b_i^T u: positive if it yields in tension
};

struct CollapseMode {
  std::vector<NodeVelocity> moving;      ///< nodes that move, in their order
  std::vector<YieldingMember> yielding;  ///< in their order
  /// Whether every velocity is along the resultant of the reference load: what the paper calls a
  /// sway-type mode.
  bool sway = false;
};

/// @param motion u, n^d, f_R^T u = 1
CollapseMode collapse_mode(const LimitProblem& problem, const Eigen::VectorXd& motion);

}  // namespace kusabi::problems
