// Random structures with all kinds of dependent displacements, and their displacements under loads
// by an independent method: multipliers for all constraints.
#pragma once

#include <random>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems::test {

/// Two bodies of bars, in the plane with an element between them: a pair of nodes, a node opposite
/// to a place between two others, a node opposite to one with an inclined support, a candidate on a
/// rigid obstacle, a multi-point constraint, and last a candidate on a roller, whose normal is the
/// first axis and which is supported along the second.
Structure random_bodies(int dimension, std::mt19937& bits);

/// The structure with all bars and elements replaced by one matrix.
Structure with_a_matrix(Structure structure);

/// F without change of coordinates: all displacements are unknowns, supports and constraints are
/// equations with multipliers, a pair's reaction acts on both of its sides. Zero along the
/// direction of a roller. dm x dm, ordered as in WedgedProblem.
Eigen::MatrixXd compliance_by_multipliers(const Structure& structure);

/// System without the missing supports: all unknowns and multipliers, and the loads of unit
/// reactions on them, by columns. Springs included.
struct MultiplierSystem {
  Eigen::MatrixXd matrix;
  Eigen::MatrixXd loads;
};
MultiplierSystem multiplier_system(const Structure& structure);

}  // namespace kusabi::problems::test
