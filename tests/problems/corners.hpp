// Random structures with several contact normals at a node, in all combinations.
#pragma once

#include <random>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems::test {

/// Two bodies of bars (`random_bodies`) with other candidates: a node in a corner of rigid walls,
/// of three in every other draw in space; one between a wall and a place of the other body; one
/// between two such places, whose nodes are themselves in a corner or on an inclined support; a
/// candidate on a roller, in space in a corner of two walls along it.
Structure random_corners(int dimension, std::mt19937& bits);

/// Unit normals at angles of at most 90 degrees, such that a node does not wedge by itself below a
/// friction of 0.7, and at least 0.3 from linear dependence.
std::vector<Eigen::VectorXd> random_normals(int dimension, int count, std::mt19937& bits);

}  // namespace kusabi::problems::test
