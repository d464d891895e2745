// The stiffness of a four-node element, every entry enclosed.
#pragma once

#include "verify/assembly.hpp"

namespace kusabi::verify {

/// Adds sum_g t |det J_g| B_g' D B_g over the 2 x 2 Gauss points, whose weights are 1, to the
/// entries of its free displacements.
void add_element(const Structure& structure, const Freedom& freedom, const PlaneElement& element,
                 SparseEnclosure& matrix);

}  // namespace kusabi::verify
