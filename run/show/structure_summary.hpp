// Summary of a structure in a few lines.
#pragma once

#include <string>

#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// Sizes, supports, candidates and loads, one line each, with a final line end.
std::string structure_summary(const problems::Structure& structure);

}  // namespace kusabi::run
