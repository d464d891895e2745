// The kinds of elements in Gmsh's files: their numbers, and their order of nodes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

/// The shape of an element of Gmsh's type `type`; nothing if there are no such elements here.
std::optional<MeshShape> gmsh_shape(int type);

/// What Gmsh calls a type: "a prism of 6 nodes", "type 77".
std::string gmsh_called(int type);

/// What makes a mesh without such elements; empty: nothing by itself.
std::string gmsh_remedy(int type);

/// Brings the nodes of an element from Gmsh's order into that of `MeshShape`: those in the middle
/// of sides differ in tetrahedra of 10 and hexahedra of 20 nodes.
std::vector<int> from_gmsh_order(MeshShape shape, const std::vector<int>& nodes);

}  // namespace kusabi::problems
