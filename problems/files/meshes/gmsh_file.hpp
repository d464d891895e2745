// Reading Gmsh's mesh files: MSH 2.2 and 4.1, ASCII.
#pragma once

#include <string>
#include <string_view>

#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

/// Nodes, elements and physical groups. A group without a name is called by its kind and tag:
/// "curve.5". Elements that MSH 2.2 repeats, once for each of their groups, are one.
/// @param file how errors name it
/// @throws InputError at the first fault, or what is not understood
MeshData read_gmsh(std::string_view text, const std::string& file);

}  // namespace kusabi::problems
