// Conversion of a structure to the plain data of verify/. File reading is the only code shared by
// searches and proofs.
#pragma once

#include <string>

#include "problems/structure/model/structure.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::evidence {

/// @param structure as read, checked
verify::Structure verified_structure(const problems::Structure& structure);

/// The same with the imposed forces as a part of the dead load.
verify::Structure verified_under_load(const problems::Structure& structure);

}  // namespace kusabi::evidence
