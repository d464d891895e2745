// Checks of a stiffness computed by another program: that it is symmetric and positive
// semidefinite, and that it constrains its body together with the supports.
//
// Its numbers are taken as exact although they are rounded. The matrix of an unconstrained body
// then has rigid-body modes only approximately, and a proof for that matrix would not hold for the
// body. Structures that are constrained only by rounding errors of a matrix are therefore refused.
#pragma once

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// Checks sizes, rows, that all entries are finite, that the matrix is exactly symmetric with a
/// positive diagonal, and that it has no negative eigenvalue beyond its rounding.
/// @throws InputError at the first fault
void check_superelements(const Structure& structure);

/// Refuses a structure whose stiffness, scaled to a diagonal of ones, is not definite beyond the
/// rounding of its superelements.
/// @throws InputError with the names of nodes that move
/// @pre the structure passes `check_structure`
void refuse_unconstrained(const Structure& structure, const FreeDegrees& degrees);

}  // namespace kusabi::problems
