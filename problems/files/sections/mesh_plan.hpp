// What the meshes of a problem file have in common: their materials, and whether they are joined.
#pragma once

#include <set>
#include <vector>

#include "problems/files/sections/material_section.hpp"
#include "problems/files/sections/problem_draft.hpp"

namespace kusabi::problems {

/// What all meshes of a problem file have in common.
struct MeshPlan {
  std::vector<GroupMaterial> materials;
  std::vector<std::string> element_groups{};  ///< of the meshes so far, as the file calls them
  std::set<int> apart;       ///< nodes of meshes with join = false: no other mesh is joined to them
  std::vector<bool> joined;  ///< one an element: whether its mesh is joined to others
};

/// Meshes are joined where their nodes are, and nowhere else.
/// @param first_new of the elements of the latest mesh
/// @throws InputError if that leaves a gape
void refuse_gapes(const ProblemDraft& draft, int first_new, const MeshPlan& plan);

/// The value of `join`: true without it.
bool joins(const TomlReader& reader, const TomlTable& group);

}  // namespace kusabi::problems
