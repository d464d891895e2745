// Utilisation by members, vectors by nodes.
#include "problems/limit/utilisation.hpp"

#include <cmath>

namespace kusabi::problems {

Eigen::VectorXd utilisation(const LimitProblem& problem, const Eigen::VectorXd& forces) {
  Eigen::VectorXd used = Eigen::VectorXd::Zero(forces.size());
  for (Eigen::Index i = 0; i < forces.size(); ++i) {
    const double strength = forces(i) >= 0 ? problem.tension(i) : problem.compression(i);
    if (strength > 0) used(i) = std::abs(forces(i)) / strength;
  }
  return used;
}

Eigen::MatrixXd node_by_node(const LimitProblem& problem, const Eigen::VectorXd& vector) {
  Eigen::MatrixXd at_nodes =
      Eigen::MatrixXd::Zero(problem.degrees.number.rows(), problem.degrees.number.cols());
  for (Eigen::Index node = 0; node < at_nodes.cols(); ++node) {
    for (Eigen::Index axis = 0; axis < at_nodes.rows(); ++axis) {
      if (const int degree = problem.degrees.number(axis, node); degree >= 0)
        at_nodes(axis, node) = vector(degree);
    }
  }
  return at_nodes;
}

}  // namespace kusabi::problems
