// Utilisation of members: axial force relative to yield force.
#pragma once

#include <Eigen/Core>

#include "problems/limit/limit_problem.hpp"

namespace kusabi::problems {

/// |q| relative to q^t in tension and to q^c in compression, n^m: 1 at yield, 0 if both the force
/// and the yield force are zero.
/// @param forces q, n^m
Eigen::VectorXd utilisation(const LimitProblem& problem, const Eigen::VectorXd& forces);

/// A vector over the free displacements at all nodes, d x nodes: zero where they are fixed.
Eigen::MatrixXd node_by_node(const LimitProblem& problem, const Eigen::VectorXd& vector);

}  // namespace kusabi::problems
