// Reader of the model of an Abaqus or CalculiX input file (.inp).
#pragma once

#include <string>

#include "problems/files/meshes/mesh_data.hpp"
#include "problems/files/meshes/mesh_texts.hpp"

namespace kusabi::problems {

/// Reads nodes, elements, sets, surfaces, isotropic materials, sections and supports. Other
/// keywords are left out with one warning each; misspelt ones, those that generate nodes or
/// elements, and unknown parameters are errors.
///
/// A node set, an element set and a surface with the same name are one group.
/// @param place of the file, as in `MeshTexts`
/// @throws InputError at the first fault
MeshData read_abaqus(const MeshTexts& texts, const std::string& place);

}  // namespace kusabi::problems
