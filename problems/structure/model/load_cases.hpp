// Load cases: sets of loads and uncertain loads that act one at a time.
#pragma once

#include <string>
#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// The names of the load cases, in the order of the file; none if all loads act together.
std::vector<std::string> load_cases(const Structure& structure);

/// The structure with the loads of one case and the loads common to all cases, without cases.
/// @param name one of `load_cases`
Structure in_load_case(Structure structure, const std::string& name);

/// Text of error messages with the available cases.
std::string choice_of_load_cases(const Structure& structure);

/// For analyses of one load.
/// @throws InputError at the first uncertain load whose half-width is in the file
void check_certain(const Structure& structure);

}  // namespace kusabi::problems
