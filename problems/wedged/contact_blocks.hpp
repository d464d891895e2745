// Decoupled blocks of contact candidates.
//
// A reaction at one candidate displaces another only if bars and elements connect both through free
// displacements. Otherwise the corresponding entries of K and F are zero exactly: the problem is a
// product of smaller ones, and each block is searched by itself (docs/theory/wedged.md, "Blocks").
// The decision depends on connectivity only, so no rounding is involved.
#pragma once

#include <span>
#include <vector>

#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"
#include "support/index_set.hpp"

namespace kusabi::problems {

/// The candidates of each block: a partition of all, in the order of the first candidates. A bar
/// connects the displacements that change its length (if it lies along an axis, only those along
/// it), an element those of all its nodes, a candidate its own, an unconstrained body all of its
/// own.
/// @param bodies those of the structure
/// @pre the structure passes `check_structure`
std::vector<support::IndexSet> contact_blocks(const Structure& structure,
                                              const FreeDegrees& degrees,
                                              std::span<const UnconstrainedBody> bodies);

}  // namespace kusabi::problems
