// Description of a collapse mode: moving nodes, yielding members, and whether all move
// along the reference load.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "problems/limit/limit_problem.hpp"

namespace kusabi::problems {

/// Velocities and elongations count as nonzero above this part of the largest velocity: basic
/// solutions have rounding errors of about 1e-12, and significant velocities of a mode have similar
/// sizes.
inline constexpr double visible_motion = 1e-7;

struct NodeVelocity {
  int node;
  Eigen::VectorXd velocity;  ///< d; normalised by f_R^T u = 1, per unit of force
};

struct YieldingMember {
  int member;
  double elongation;  ///< rate b_i^T u: positive if it yields in tension
};

struct CollapseMode {
  std::vector<NodeVelocity> moving;      ///< moving nodes, in their order
  std::vector<YieldingMember> yielding;  ///< in their order
  /// True if every velocity is along the resultant of the reference load: under horizontal forces the
  /// sway-type mode of the paper.
  bool along_reference = false;
};

/// @param motion u, n^d, f_R^T u = 1
CollapseMode collapse_mode(const LimitProblem& problem, const Eigen::VectorXd& motion);

}  // namespace kusabi::problems
