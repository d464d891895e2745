// Velocities by nodes, elongations by members.
#include "problems/limit/collapse_mode.hpp"

#include <cmath>

namespace kusabi::problems {
namespace {

/// Components of a node in a vector over the free displacements; zero where supported.
Eigen::VectorXd at_node(const LimitProblem& problem, const Eigen::VectorXd& vector, int node) {
  Eigen::VectorXd part = Eigen::VectorXd::Zero(problem.dimension);
  for (int axis = 0; axis < problem.dimension; ++axis) {
    const int degree = problem.degrees.number(axis, node);
    if (degree >= 0) part(axis) = vector(degree);
  }
  return part;
}

}  // namespace

CollapseMode collapse_mode(const LimitProblem& problem, const Eigen::VectorXd& motion) {
  CollapseMode mode;
  const double minimum = visible_motion * motion.cwiseAbs().maxCoeff();
  Eigen::VectorXd resultant = Eigen::VectorXd::Zero(problem.dimension);
  const int nodes = static_cast<int>(problem.node_names.size());
  for (int node = 0; node < nodes; ++node) {
    resultant += at_node(problem, problem.reference, node);
    Eigen::VectorXd velocity = at_node(problem, motion, node);
    if (velocity.cwiseAbs().maxCoeff() > minimum)
      mode.moving.push_back({node, std::move(velocity)});
  }
  const Eigen::VectorXd elongation = problem.equilibrium.transpose() * motion;
  for (int member = 0; member < problem.member_count(); ++member) {
    if (std::abs(elongation(member)) > minimum)
      mode.yielding.push_back({member, elongation(member)});
  }
  if (!resultant.isZero(0.0)) {
    const Eigen::VectorXd direction = resultant.normalized();
    mode.along_reference = true;
    for (const auto& [node, velocity] : mode.moving) {
      const Eigen::VectorXd across = velocity - direction * direction.dot(velocity);
      if (across.cwiseAbs().maxCoeff() > minimum) mode.along_reference = false;
    }
  }
  return mode;
}

}  // namespace kusabi::problems
