// Element types of Gmsh files: their numbers and their order of nodes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

/// The shape of an element of Gmsh's type `type`; nothing if the type is not supported.
std::optional<MeshShape> gmsh_shape(int type);

/// Name of a type in messages: "a prism of 6 nodes", "type 77".
std::string gmsh_called(int type);

/// The setting of a mesh generator that avoids such elements; empty if there is none.
std::string gmsh_remedy(int type);

/// Converts the nodes of an element from Gmsh's order to that of `MeshShape`: midpoints of edges
/// differ in tetrahedra with 10, hexahedra with 20 and prisms with 15 nodes.
std::vector<int> from_gmsh_order(MeshShape shape, const std::vector<int>& nodes);

}  // namespace kusabi::problems
