// Which elements of a mesh are the body, which are bars, and what they are made of; the others only
// name parts of its surface.
#pragma once

#include <string>
#include <vector>

#include "problems/files/meshes/mesh_data.hpp"
#include "problems/files/sections/material_section.hpp"
#include "problems/files/sections/problem_draft.hpp"

namespace kusabi::problems {

struct MeshUse {
  enum class Role { name, body, bar };
  Role role = Role::name;
  const GroupMaterial* material = nullptr;  ///< of a [[material]]
  const MeshSection* section = nullptr;     ///< of the file
};

/// What each element of a mesh is for. The body is what has the dimension of the problem; lines of
/// two nodes are bars if a [[material]] or a section of the file says what of.
/// @param name of the mesh  @param mesh, materials they must outlive the result
/// @throws InputError if an element is of too high a dimension, has two materials, or if there is
///         neither a body nor a bar
std::vector<MeshUse> mesh_uses(const ProblemDraft& draft, const MeshData& mesh,
                               const std::string& name, std::vector<GroupMaterial>& materials);

/// An error that names the file of a mesh and the line.
[[noreturn]] void fail_in_mesh(const MeshData& mesh, MeshPlace at, const std::string& message);

}  // namespace kusabi::problems
