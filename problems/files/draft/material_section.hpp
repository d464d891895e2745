// Materials by group: [[material]], and the corresponding keys of a [[mesh]] for all its elements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/files/draft/problem_draft.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// The material of the elements of some groups: of a body, or of bars.
struct GroupMaterial {
  std::vector<TomlText> groups;
  std::vector<bool> found;  ///< by group: whether a mesh has it
  bool of_bars = false;
  Element element{};  ///< without nodes
  bool has_plane = false;
  Member bar{};  ///< without nodes
  support::SourcePosition position;
};

/// The keys E, nu, thickness, plane, density and expansion of a table; in space without thickness
/// and plane. Without `plane` the elements must specify it.
GroupMaterial body_material(const ProblemDraft& draft, const TomlTable& table);

/// All of [[material]].
std::vector<GroupMaterial> read_materials(const ProblemDraft& draft);

/// @param element_groups those of the meshes
/// @throws InputError at the first group that no mesh has
void require_all_found(const ProblemDraft& draft, const std::vector<GroupMaterial>& materials,
                       const std::vector<std::string>& element_groups);

/// Checks the groups of materials for an element without material, since one may be misspelt.
/// @throws InputError at a group that the mesh does not have and whose name resembles one of it
void refuse_misspelt(const ProblemDraft& draft, const std::vector<GroupMaterial>& materials,
                     const std::vector<std::string>& element_groups, const std::string& mesh);

}  // namespace kusabi::problems
