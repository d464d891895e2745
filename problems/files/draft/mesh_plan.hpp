// Data common to the meshes of a problem file: their materials, and the joined ones.
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "problems/files/draft/material_section.hpp"
#include "problems/files/draft/problem_draft.hpp"

namespace kusabi::problems {

/// Data common to all meshes of a problem file.
struct MeshPlan {
  std::vector<GroupMaterial> materials;
  std::vector<std::string>
      element_groups{};  ///< of the meshes so far, with their names in the file
  std::set<int> apart;   ///< nodes of meshes with join = false, to which no other mesh is joined
  std::vector<bool> joined;  ///< by element: whether its mesh is joined to others
};

/// Checks for gaps: meshes are joined at common nodes only.
/// @param first_new of the elements of the latest mesh
/// @throws InputError if there is a gap
void refuse_gapes(const ProblemDraft& draft, int first_new, const MeshPlan& plan);

/// The value of a key `true` or `false` of a group; true without it.
bool truth_of(const TomlReader& reader, const TomlTable& group, std::string_view key);

}  // namespace kusabi::problems
