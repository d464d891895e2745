// Bodies of a structure: components connected by members, elements and multi-point constraints; and
// warnings of coincident nodes that are not connected, as in meshes whose parts were generated
// separately.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// True if a node is supported along every axis. Such a node belongs to the ground.
bool is_ground(const Structure& structure, int node);

/// The nodes of each body, including ground nodes that touch it, in the order of their first free
/// nodes. Ground nodes do not connect bodies, nor does a candidate `against` another body.
std::vector<std::set<int>> connected_bodies(const Structure& structure);

/// One line if nodes of two bodies, or two nodes of one, coincide without being connected by
/// elements, multi-point constraints or contact.
std::vector<std::string> coincidence_warnings(const Structure& structure);

}  // namespace kusabi::problems
