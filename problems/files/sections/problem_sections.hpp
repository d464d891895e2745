// Sections of a problem file that define bodies and supports, each in a file of its name
// (docs/problem-files.md). Nodes and meshes come first, since all others refer to their nodes.
#pragma once

#include "problems/files/draft/problem_draft.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// [[mesh]]: nodes, edges and elements.
void read_meshes(ProblemDraft& draft);

/// [[members]], optional in a file with elements.
void read_members(ProblemDraft& draft);

/// [[elements]].
void read_elements(ProblemDraft& draft);

/// [[supports]], optional.
void read_supports(ProblemDraft& draft);

/// [[springs]].
void read_springs(ProblemDraft& draft);

/// [[stiffness]]. The elements of the named meshes become outlines.
void read_stiffnesses(ProblemDraft& draft);

/// True if a [[stiffness]] contains that of the mesh.
bool is_of_stiffness(const ProblemDraft& draft, std::string_view mesh);

/// [[ties]].
void read_ties(ProblemDraft& draft);

/// [[contact]].
void read_contact(ProblemDraft& draft);

/// The weight by `gravity` as dead loads, and the forces of `temperature` and displaced supports.
/// After all other sections.
void read_body_loads(ProblemDraft& draft);

/// An element without nodes, with the material of a group.
Element material(const TomlReader& reader, const TomlTable& group, int dimension);

/// Adds an element of that material.
/// @param position of its nodes  @param material_position for errors of its material
void add_element(ProblemDraft& draft, Element element, std::vector<int> nodes,
                 support::SourcePosition position, support::SourcePosition material_position);

}  // namespace kusabi::problems
