// Nodes of contact pairs that differ from their opposite place only by rounding of their
// coordinates; the proofs move them to that place exactly (docs/theory/proofs.md,
// "Unconstrained bodies").
#pragma once

#include <cstddef>
#include <map>

#include "verify/arithmetic/elimination.hpp"
#include "verify/arithmetic/enclosure.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// By node, the exact sum of weights times the nodes opposite to it. Nodes exactly at that place,
/// or farther from it than rounding, are not included.
std::map<std::size_t, Rationals> placed_nodes(const Structure& structure);

/// Coordinate of a node along an axis, or of its exact place.
Enclosure coordinate(const Structure& structure, std::size_t node, std::size_t axis);

}  // namespace kusabi::verify
