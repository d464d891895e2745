// Nodes that are several candidates: the displacements u_a of such a node are made of those along
// its normals n_i, q_i = n_i.(u_a - p_i), where p_i is the place that candidate i is against. What
// a candidate sees along a tangent t is a displacement of its own, on a spring to t.(u_a - p_i):
// of no account to any answer, and K is definite with it (docs/theory/wedged.md, "Corners").
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "verify/structure/freedom.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// By candidate in a corner: the numbers of its displacements n, t1[, t2].
using CornerNumbers = std::map<std::size_t, std::vector<std::size_t>>;

/// Rewrites the stiffness: the numbers of a corner's node become those along its normals and, in
/// space, of what two normals leave; tangential ones are added at the end. Not all finite where
/// normals depend on each other.
CornerNumbers turn_corners(const Structure& structure, Freedom& freedom,
                           SparseEnclosure& stiffness);

}  // namespace kusabi::verify
