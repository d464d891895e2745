// Writer of a structure as a problem file that read_structure can read.
#pragma once

#include <string>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// The text of a problem file. Numbers have enough digits to be read back exactly.
/// @pre the structure has no superelements, whose matrices are separate files
std::string structure_text(const Structure& structure);

}  // namespace kusabi::problems
