// What becomes of a mesh whose stiffness another program has computed.
#pragma once

#include <set>

#include "problems/files/sections/problem_draft.hpp"

namespace kusabi::problems {

/// Makes the elements of the meshes outlines, and holds those of their nodes that nothing else of
/// the structure, superelements included, hangs on.
void set_outlines(const std::set<const NamedMesh*>& meshes, Structure& structure);

}  // namespace kusabi::problems
