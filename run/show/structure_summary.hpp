// Summary of a structure in a few lines.
#pragma once

#include <string>

#include "problems/structure/checks/checked_structure.hpp"

namespace kusabi::run {

/// Sizes, supports, candidates and loads, one line each, with a final line end.
std::string structure_summary(const problems::CheckedStructure& structure);

}  // namespace kusabi::run
