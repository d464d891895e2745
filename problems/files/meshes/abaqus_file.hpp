// Reading the model of an Abaqus or CalculiX input file (.inp).
#pragma once

#include <string>

#include "problems/files/meshes/mesh_data.hpp"
#include "problems/files/meshes/mesh_texts.hpp"

namespace kusabi::problems {

/// Nodes, elements, sets, surfaces, isotropic materials, sections and supports. What has no part
/// in the linear elasticity of the body (steps, loads, output) is left out with a warning that
/// names it; any other keyword or parameter that is not understood is an error.
///
/// A node set, an element set and a surface of one name are one group.
/// @param place of the file, as in `MeshTexts`
/// @throws InputError at the first fault
MeshData read_abaqus(const MeshTexts& texts, const std::string& place);

}  // namespace kusabi::problems
