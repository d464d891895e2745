// Mesh files of any format, distinguished by the file extension.
#pragma once

#include <string>
#include <string_view>

#include "problems/files/meshes/mesh_data.hpp"
#include "problems/files/meshes/mesh_texts.hpp"
#include "problems/files/toml/toml_reader.hpp"

namespace kusabi::problems {

/// The value of `file` in a [[mesh]].
/// @throws InputError unless it ends in .msh (Gmsh) or .inp (Abaqus, CalculiX)
TomlText mesh_file_name(const TomlReader& reader, const toml::node& entry);

bool is_abaqus_file(std::string_view name);

/// @param place of the file, as in `MeshTexts`
/// @throws InputError at the first fault, with the mesh file's name and line
MeshData read_mesh_file(const MeshTexts& texts, const std::string& place);

}  // namespace kusabi::problems
