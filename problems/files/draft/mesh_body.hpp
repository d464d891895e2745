// Use of each element of a mesh, body or bar, and its material; other elements only name parts of
// the surface.
#pragma once

#include <string>
#include <vector>

#include "problems/files/draft/material_section.hpp"
#include "problems/files/draft/problem_draft.hpp"
#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

struct MeshUse {
  enum class Role { name, body, bar };
  Role role = Role::name;
  const GroupMaterial* material = nullptr;  ///< of a [[material]]
  const MeshSection* section = nullptr;     ///< of the file
};

/// The use of each element of a mesh. Elements with the dimension of the problem are the body;
/// lines of two nodes are bars if a [[material]] or a section of the file defines their properties.
/// @param name of the mesh  @param mesh, materials they must outlive the result
/// @throws InputError if an element has too high a dimension or two materials, or if there is
///         neither a body nor a bar
std::vector<MeshUse> mesh_uses(const ProblemDraft& draft, const MeshData& mesh,
                               const std::string& name, std::vector<GroupMaterial>& materials);

/// @throws InputError with the mesh file and the line
[[noreturn]] void fail_in_mesh(const MeshData& mesh, MeshPlace at, const std::string& message);

}  // namespace kusabi::problems
