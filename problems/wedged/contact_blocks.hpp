// Which contact candidates feel each other: the blocks that a structure comes apart into.
//
// A reaction at one candidate moves another only if bars and elements connect the two through
// displacements that nothing supports. Where they do not, K and F of the wedged problem are zero
// exactly, whatever the numbers: the problem is a product of smaller ones, and each block may be
// searched by itself (docs/theory/wedged.md, "Blocks"). Decided by structure, so nothing is
// rounded.
#pragma once

#include <span>
#include <vector>

#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"
#include "support/index_set.hpp"

namespace kusabi::problems {

/// The candidates of each block: a partition of all, in the order of the first candidates. A bar
/// connects the displacements that stretch it (one that lies along an axis leaves the others
/// alone), an element those of all its nodes, a candidate its own, a loose body all of its own.
/// @param bodies those of the structure
/// @pre the structure passes `check_structure`
std::vector<support::IndexSet> contact_blocks(const Structure& structure,
                                              const FreeDegrees& degrees,
                                              std::span<const LooseBody> bodies);

}  // namespace kusabi::problems
