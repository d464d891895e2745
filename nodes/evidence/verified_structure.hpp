// From a problem file to the plain data that verify/ proves something of. Reading files is all that
// the searches and the proofs share; the mathematics is not.
#pragma once

#include <string>

#include "problems/structure/model/structure.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::evidence {

/// @param structure as read, checked
verify::Structure verified_structure(const problems::Structure& structure);

}  // namespace kusabi::evidence
