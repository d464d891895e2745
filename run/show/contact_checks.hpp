// Geometry of contact before an analysis: surfaces that touch, their normals, coincident nodes.
#pragma once

#include <string>
#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// One line for each surface of candidates: its name, the bodies that touch, the number of
/// candidates, the shape of which their normals are, and their distance from it.
std::vector<std::string> touching_surfaces(const problems::Structure& structure);

/// Nodes of different parts at one place without connection, in words.
std::string coincident_nodes(const problems::Structure& structure);

}  // namespace kusabi::run
