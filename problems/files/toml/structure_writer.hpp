// Writes a structure as a problem file, which read_structure reads back.
#pragma once

#include <string>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// The text of a problem file. Numbers are written so that they are read back to the last bit.
/// @pre the structure has no superelements, whose matrices are files of their own
std::string structure_text(const Structure& structure);

}  // namespace kusabi::problems
