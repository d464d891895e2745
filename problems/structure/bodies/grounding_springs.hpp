// Grounding springs of unconstrained bodies for the computation of F (docs/theory/wedged.md,
// "Unconstrained bodies"). No force acts in them when the reactions are in equilibrium, so their
// choice does not influence any answer.
#pragma once

#include <span>
#include <vector>

#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// One spring for each mode, at nodes and axes far apart, each with a power of two near the
/// stiffness of its node.
/// @param degrees, bodies those of the structure
std::vector<Spring> grounding_springs(const Structure& structure, const FreeDegrees& degrees,
                                      std::span<const UnconstrainedBody> bodies);

/// The structure with grounding springs: it has no rigid-body modes, and the same free
/// displacements.
Structure grounded_structure(Structure structure, const FreeDegrees& degrees,
                             std::span<const UnconstrainedBody> bodies);

}  // namespace kusabi::problems
