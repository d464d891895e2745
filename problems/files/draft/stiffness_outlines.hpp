// Meshes whose stiffness was computed by another program.
#pragma once

#include <set>

#include "problems/files/draft/problem_draft.hpp"

namespace kusabi::problems {

/// Makes the elements of the meshes outlines, and supports their nodes that nothing else in the
/// structure, including superelements, is connected to.
void set_outlines(const std::set<const NamedMesh*>& meshes, Structure& structure);

}  // namespace kusabi::problems
