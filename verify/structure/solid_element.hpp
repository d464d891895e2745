// Enclosed stiffness of an isoparametric element.
#pragma once

#include "verify/structure/assembly.hpp"

namespace kusabi::verify {

/// Adds sum_g w_g t |det J_g| B_g' D B_g to the entries of its free displacements.
/// @throws std::invalid_argument if no shape has this number of nodes
void add_element(const Structure& structure, const Freedom& freedom, const Element& element,
                 SparseEnclosure& matrix);

}  // namespace kusabi::verify
