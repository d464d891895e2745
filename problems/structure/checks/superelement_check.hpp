// The rules for a stiffness that another program has computed: that it is one, and that with the
// supports it holds its body.
//
// Its numbers are meant exactly, and rounded all the same: a body that nothing holds has a matrix
// that almost, but not exactly, lets it move as a whole. A proof about that matrix would be none
// about the body, so what is held by no more than the rounding of its numbers is refused.
#pragma once

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// Checks sizes, rows, that all entries are finite, that the matrix is symmetric to the last bit
/// with a positive diagonal, and that it has no negative eigenvalue beyond its rounding.
/// @throws InputError at the first fault
void check_superelements(const Structure& structure);

/// Refuses a structure whose stiffness, scaled to a diagonal of ones, is not definite by more than
/// the rounding of its superelements.
/// @throws InputError with the names of nodes that move
/// @pre the structure passes `check_structure`
void refuse_unheld(const Structure& structure, const FreeDegrees& degrees);

}  // namespace kusabi::problems
