// Warnings about loads and clearances that a subcommand ignores: wedged configurations exist
// without load, and fit exactly.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// One line for loads, one for clearances, each if the file has any.
std::vector<std::string> ignored_loads(const problems::Structure& structure,
                                       std::string_view command);

/// A line for the uncertain loads whose half-widths the file does not give, if there are any.
std::vector<std::string> ignored_uncertainty(const problems::Structure& structure,
                                             std::string_view command);

}  // namespace kusabi::run
