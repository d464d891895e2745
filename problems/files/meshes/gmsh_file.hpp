// Reader of Gmsh's mesh files: MSH 2.2 and 4.1, ASCII and binary.
#pragma once

#include <string>
#include <string_view>

#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

/// Reads nodes, elements and physical groups. The name of an unnamed group is its kind and tag:
/// "curve.5". Elements that MSH 2.2 repeats for each of their groups are merged.
/// @param file name in messages
/// @throws InputError at the first fault or unsupported entry
MeshData read_gmsh(std::string_view text, const std::string& file);

}  // namespace kusabi::problems
