// Which contact candidates feel each other: the blocks that a structure comes apart into.
//
// A reaction at one candidate moves another only if bars and elements connect the two through
// displacements that nothing supports. Where they do not, K and F of the wedged problem are zero
// exactly, whatever the numbers: the problem is a product of smaller ones, and each block may be
// searched by itself (docs/theory/wedged.md, "Blocks"). Decided by structure, so nothing is
// rounded.
#pragma once

#include <cstdint>
#include <vector>

#include "problems/structure/structure.hpp"
#include "problems/structure/truss.hpp"

namespace kusabi::problems {

/// The candidates of each block, bit i for candidate i: a partition of all m <= 64, in the order of
/// the first candidates. A bar connects the displacements that stretch it (one that lies along an
/// axis leaves the others alone), an element those of all its nodes, a candidate its own.
/// @pre the structure passes `check_structure`
std::vector<std::uint64_t> contact_blocks(const Structure& structure, const FreeDegrees& degrees);

}  // namespace kusabi::problems
