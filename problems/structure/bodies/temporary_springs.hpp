// Springs that hold loose bodies while F is computed (docs/theory/wedged.md, "Loose bodies").
// Forces in equilibrium leave them without force, so it does not matter which they are.
#pragma once

#include <span>
#include <vector>

#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// One spring a motion, at nodes and axes far apart, each a power of two near the stiffness that
/// its node has already.
/// @param bodies those of the structure
std::vector<Spring> temporary_springs(const Structure& structure,
                                      std::span<const LooseBody> bodies);

/// The structure with these springs: none of it can move without strain, unless it is a mechanism.
Structure held_structure(Structure structure, std::span<const LooseBody> bodies);

}  // namespace kusabi::problems
