// Common structure of the sections of a Gmsh file: $Name, data lines, $EndName; and the first
// section, which specifies the version.
#pragma once

#include <string>
#include <string_view>

#include "problems/files/meshes/mesh_text.hpp"

namespace kusabi::problems {

/// Reads $MeshFormat, at the beginning of the file.
/// @return 2 (MSH 2.2) or 4 (MSH 4.1)
/// @throws InputError if it is another version
int read_gmsh_version(MeshText& text);

/// Goes to the next line. @throws InputError at the end of the file or of the section
void next_data(MeshText& text, std::string_view expected);

/// Goes to the next line. @throws InputError if it is not $EndName
void end_section(MeshText& text, const std::string& name);

/// Goes to the end of the section.
void skip_section(MeshText& text, const std::string& name);

}  // namespace kusabi::problems
