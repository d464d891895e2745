// The rules for displacements that are made of others: pairs, ties, inclined supports, and
// candidates on rollers.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Smallest and largest size of the share of a node in a place: those of a point of an edge or a
/// face are from rounding to one.
inline constexpr double smallest_share = 1e-12;
inline constexpr double largest_share = 1e3;

/// Checks that no node follows others twice, follows itself or one that follows others; that what
/// follows is free to; the shares; that an inclined support has a direction and holds nothing that
/// is held already; that a roller at a candidate holds it along the obstacle.
/// @throws InputError at the first fault, rule by rule
void check_constraints(const Structure& structure);

}  // namespace kusabi::problems
