// Checks of dependent displacements: contact pairs, multi-point constraints, inclined supports and
// candidates on rollers.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Smallest and largest absolute weight of a node in a place. The weights of a point of an edge or
/// face are between rounding error and one.
inline constexpr double smallest_share = 1e-12;
inline constexpr double largest_share = 1e3;

/// Checks that no node depends on others twice, on itself or on a dependent node; that dependent
/// displacements are free; the weights; that an inclined support has a direction and no axis that
/// is supported already; that a roller at a candidate acts along the obstacle.
/// @throws InputError at the first fault, rule by rule
void check_constraints(const Structure& structure);

}  // namespace kusabi::problems
