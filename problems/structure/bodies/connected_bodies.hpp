// The bodies of a structure: its pieces that members, elements and ties connect. And the nodes at
// one place that nothing joins, as those of a mesh whose halves were made apart.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Whether a node is supported along every axis. Such a node belongs to the ground.
bool is_ground(const Structure& structure, int node);

/// The nodes of each body, those of the ground that touch it included, in the order of their first
/// free nodes. The ground connects nothing, nor does a candidate `against` another body.
std::vector<std::set<int>> connected_bodies(const Structure& structure);

/// A line for all places where nodes of two bodies, or two nodes of one, coincide and neither
/// elements, ties nor contact join them.
std::vector<std::string> coincidence_warnings(const Structure& structure);

}  // namespace kusabi::problems
