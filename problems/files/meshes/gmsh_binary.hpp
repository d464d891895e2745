// Binary mesh files of Gmsh as ASCII ones of the same version, which gmsh_file reads.
#pragma once

#include <string>
#include <string_view>

namespace kusabi::problems {

/// True for a file that begins as a binary mesh.
bool is_binary_gmsh(std::string_view bytes);

/// The same mesh as text. Sections that do not change the mesh are left out.
/// @param file name in messages
/// @throws InputError if the file ends within a section, or is of another version
std::string gmsh_as_text(std::string_view bytes, const std::string& file);

}  // namespace kusabi::problems
