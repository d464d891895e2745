// What is said of loads in the file of a question that has none: a wedged configuration holds
// without any load.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// A line, or none if the file has no loads and no uncertain ones.
std::vector<std::string> ignored_loads(const problems::Structure& structure,
                                       std::string_view command);

}  // namespace kusabi::run
