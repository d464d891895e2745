// Materials by group: [[material]], and the keys of a [[mesh]] that say the same of all its
// elements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/files/sections/problem_draft.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// What the elements of some groups are made of: a body, or bars.
struct GroupMaterial {
  std::vector<TomlText> groups;
  std::vector<bool> found;  ///< one a group: whether a mesh has it
  bool of_bars = false;
  Element element{};  ///< without nodes
  bool has_plane = false;
  Member bar{};  ///< without nodes
  support::SourcePosition position;
};

/// The keys E, nu, thickness and plane of a table; in space there are only the first two. Without
/// `plane` the elements must say it themselves.
GroupMaterial body_material(const ProblemDraft& draft, const TomlTable& table);

/// All of [[material]].
std::vector<GroupMaterial> read_materials(const ProblemDraft& draft);

/// @param element_groups those that meshes have
/// @throws InputError at the first group that no mesh has
void require_all_found(const ProblemDraft& draft, const std::vector<GroupMaterial>& materials,
                       const std::vector<std::string>& element_groups);

/// Of an element without a material: the group of one may be meant that is spelt otherwise.
/// @throws InputError at a group that the mesh does not have, but one that is nearly called so
void refuse_misspelt(const ProblemDraft& draft, const std::vector<GroupMaterial>& materials,
                     const std::vector<std::string>& element_groups, const std::string& mesh);

}  // namespace kusabi::problems
