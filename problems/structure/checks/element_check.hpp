// Checks of the elements of a structure, a part of `check_structure`.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Checks materials, that each element has the nodes of its shape and the dimension of the
/// structure, and that its Jacobian determinant has one sign, and is not close to zero, at all
/// vertices and integration points.
/// @throws InputError at the first fault
void check_elements(const Structure& structure);

}  // namespace kusabi::problems
