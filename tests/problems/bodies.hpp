// Random structures with all that displacements can be made of, and what they do under loads by a
// method of its own: multipliers for everything that is held.
#pragma once

#include <random>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems::test {

/// Two bodies of bars, in the plane with an element between them: a pair of nodes, a node against a
/// place between two others, a node against one that stands on an inclined support, a candidate
/// on a rigid obstacle, a tie, and a candidate on a roller, whose normal is the first axis and
/// which is held along the second: the last of all.
Structure random_bodies(int dimension, std::mt19937& bits);

/// The structure with all bars and elements in one matrix, and nothing else of them left.
Structure with_a_matrix(Structure structure);

/// F as it is without any change of coordinates: all displacements are unknown, supports and ties
/// are equations with multipliers, a pair's reaction acts on both of its sides. Zero along what a
/// roller holds. dm x dm, ordered as in WedgedProblem.
Eigen::MatrixXd compliance_by_multipliers(const Structure& structure);

/// The same with the supports left out that there are not: all unknowns and multipliers, and the
/// loads of unit reactions on them, by columns. Springs included.
struct MultiplierSystem {
  Eigen::MatrixXd matrix;
  Eigen::MatrixXd loads;
};
MultiplierSystem multiplier_system(const Structure& structure);

}  // namespace kusabi::problems::test
