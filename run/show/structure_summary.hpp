// What a structure has of what, in a few lines.
#pragma once

#include <string>

#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// Sizes, supports, candidates and loads; a line each, the last one ended too.
std::string structure_summary(const problems::Structure& structure);

}  // namespace kusabi::run
