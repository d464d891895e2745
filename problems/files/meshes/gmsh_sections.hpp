// What all sections of a Gmsh file have in common: $Name, lines of data, $EndName; and the first,
// which says what kind of file it is.
#pragma once

#include <string>
#include <string_view>

#include "problems/files/meshes/mesh_text.hpp"

namespace kusabi::problems {

/// Reads $MeshFormat, at the beginning of the file.
/// @return 2 (MSH 2.2) or 4 (MSH 4.1)
/// @throws InputError if it is another version, or binary
int read_gmsh_version(MeshText& text);

/// Goes to the next line, which must be there and within the section.
void next_data(MeshText& text, std::string_view expected);

/// Goes to the next line, which must be $EndName.
void end_section(MeshText& text, const std::string& name);

/// Goes to the end of the section.
void skip_section(MeshText& text, const std::string& name);

}  // namespace kusabi::problems
