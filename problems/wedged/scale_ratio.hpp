// How far apart the scales of a structure are. Cut-offs in floating point are relative to the
// largest of what they compare, so far apart they may take what counts for rounding.
#pragma once

#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::problems {

/// The largest of these quotients, at least 1: the stiffest and the softest of all members,
/// elements and springs; the largest and the smallest normal compliance of the candidates of a
/// block; and of a loose body, its extent and the smallest distance in it, which is that of the
/// ends of a member, of two nodes of an element or of two candidates that are apart.
double scale_ratio(const Structure& structure, const WedgedProblem& problem);

}  // namespace kusabi::problems
