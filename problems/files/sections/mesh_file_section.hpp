// Section [[mesh]] with a `file`: adds a mesh of another program to the structure.
#pragma once

#include "problems/files/draft/mesh_plan.hpp"
#include "problems/files/draft/problem_draft.hpp"

namespace kusabi::problems {

/// Adds nodes, elements, bars, groups and supports of the mesh that a [[mesh]] group names.
void read_mesh_of_file(ProblemDraft& draft, const TomlTable& group, MeshPlan& plan);

}  // namespace kusabi::problems
