// Additional compliances c that make F definite: for tangential displacements of candidates that
// are fixed by a roller or shared with other candidates at the node. They do not influence any
// answer (docs/theory/wedged.md, "Rollers at candidates" and "Corners").
#pragma once

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"
#include "problems/wedged/scaled_stiffness.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// Adds c h h' for each axis h along which a roller acts at a candidate, where c is the inverse of
/// the stiffness of the node along the axis nearest to its normal; at a node with several normals c
/// t t' for each tangent t, where c is the inverse of the mean stiffness of the node along its free
/// axes.
/// @param compliance F, dm x dm, length/force
/// @return bound of the relative error of the added terms
double add_tangential_springs(const Structure& structure, const FreeDegrees& degrees,
                              const ScaledStiffness& stiffness, numbers::PreciseMatrix& compliance);

}  // namespace kusabi::problems
