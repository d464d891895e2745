// The sections of a problem file that make up the body and what holds it, each in a file of its
// name: which keys they have, and what these mean (docs/problem-files.md). Nodes and meshes come
// first: all else names their nodes.
#pragma once

#include "problems/files/sections/problem_draft.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// [[mesh]]: nodes, edges and elements.
void read_meshes(ProblemDraft& draft);

/// [[members]], which a file with elements may leave out.
void read_members(ProblemDraft& draft);

/// [[elements]].
void read_elements(ProblemDraft& draft);

/// [[supports]], which a file may leave out.
void read_supports(ProblemDraft& draft);

/// [[springs]].
void read_springs(ProblemDraft& draft);

/// [[stiffness]]. The elements of meshes that it names become outlines.
void read_stiffnesses(ProblemDraft& draft);

/// Whether a [[stiffness]] has that of the mesh.
bool is_of_stiffness(const ProblemDraft& draft, std::string_view mesh);

/// [[ties]].
void read_ties(ProblemDraft& draft);

/// [[contact]].
void read_contact(ProblemDraft& draft);

/// An element without nodes, of the material that the keys of a group say.
Element material(const TomlReader& reader, const TomlTable& group, int dimension);

/// Adds an element of that material.
/// @param position of its nodes  @param material_position of what errors in its material name
void add_element(ProblemDraft& draft, Element element, std::vector<int> nodes,
                 support::SourcePosition position, support::SourcePosition material_position);

}  // namespace kusabi::problems
