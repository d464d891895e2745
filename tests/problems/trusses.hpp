// Small trusses that several tests use, each simple enough for hand calculation.
#pragma once

#include <random>
#include <string>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems::test {

/// Adds a node named after its number; returns the number.
int add_node(Structure& structure, const Eigen::VectorXd& position);

/// A plane structure without any entries.
Structure empty_structure(int dimension);

void fix(Structure& structure, int node);

/// Two fixed nodes and a tip at (1, 0) on a horizontal bar of EA / L = 1 and a vertical bar of EA /
/// L = 3, which touches a surface of normal (-1, 1) / sqrt 2.
Structure two_bars();

/// A cantilever of square bays with one diagonal each, fixed at its left end, EA = 1, in contact at
/// its lower right corner from below. Node 2 i is at (i, 0), node 2 i + 1 at (i, 1).
/// @param bay_without_diagonal that bay gets none; -1: every bay has one
Structure cantilever(int bays, int bay_without_diagonal = -1);

/// Nodes at random places in a unit cube, every pair connected, no supports, no contact.
Structure random_cluster(int dimension, int nodes, std::mt19937& bits);

/// Like `random_cluster`, with the first `dimension` nodes fixed and the last three in contact,
/// each with a random normal. EA of each member is random within [1, 3].
Structure random_wedge(int dimension, int nodes, std::mt19937& bits);

Eigen::VectorXd random_vector(Eigen::Index size, std::mt19937& bits);

/// Path of a file under the root of the sources.
std::string source_path(const std::string& relative);

}  // namespace kusabi::problems::test
