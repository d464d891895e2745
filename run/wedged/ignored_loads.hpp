// Warning about loads that a subcommand ignores: wedged configurations exist without load.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// One line, or none if the file has no loads.
std::vector<std::string> ignored_loads(const problems::Structure& structure,
                                       std::string_view command);

}  // namespace kusabi::run
