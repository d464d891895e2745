// Ratio of the scales of a structure. Tolerances in floating point are relative to the largest
// number, so small scales may be mistaken for rounding errors.
#pragma once

#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::problems {

/// The largest of these quotients, at least 1: the stiffest and the softest of all members,
/// elements and springs; the largest and the smallest normal compliance of the candidates of a
/// block; and for an unconstrained body, its extent and the smallest distance between the ends of a
/// member, two nodes of an element or two candidates at different places.
double scale_ratio(const CheckedStructure& structure, const WedgedProblem& problem);

}  // namespace kusabi::problems
