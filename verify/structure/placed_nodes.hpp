// Nodes of pairs that are off the place that they are against by the rounding of their coordinates
// alone: they are meant to be there (docs/theory/proofs.md, "Loose bodies").
#pragma once

#include <cstddef>
#include <map>

#include "verify/arithmetic/elimination.hpp"
#include "verify/arithmetic/enclosure.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// By node, the sum of weights times the nodes that it is against, exactly. Nodes that are there
/// exactly, or farther off than rounding, are left out.
std::map<std::size_t, Rationals> placed_nodes(const Structure& structure);

/// Where a node is along an axis, or meant to be.
Enclosure coordinate(const Structure& structure, std::size_t node, std::size_t axis);

}  // namespace kusabi::verify
