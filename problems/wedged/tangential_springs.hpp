// What makes F definite where it is not: a compliance c of their own for those tangential
// displacements of candidates that a roller holds, or that other candidates see as well. No
// question depends on it (docs/theory/wedged.md, "Rollers at candidates" and "Corners").
#pragma once

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"
#include "problems/wedged/scaled_stiffness.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// Adds c h h' for each axis h that a roller holds at a candidate, with c the inverse of the
/// stiffness of the node along the axis nearest to its normal; in a corner c t t' for each tangent
/// t, with c the inverse of the mean stiffness of the node along its free axes.
/// @param compliance F, dm x dm, length/force
/// @return how wrong what is added may be, relative to itself
double add_tangential_springs(const Structure& structure, const FreeDegrees& degrees,
                              const ScaledStiffness& stiffness, numbers::PreciseMatrix& compliance);

}  // namespace kusabi::problems
