// Load cases: sets of loads, and of what is uncertain of them, that act one at a time.
#pragma once

#include <string>
#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Their names, in the order of the file; none if all loads act together.
std::vector<std::string> load_cases(const Structure& structure);

/// The structure with the loads of one case, and those of all: it has no cases any more.
/// @param name one of `load_cases`
Structure in_load_case(Structure structure, const std::string& name);

/// The same, as a user asks for it. @param name empty: the structure as it is
/// @throws InputError if there is no such case
Structure in_chosen_case(Structure structure, const std::string& name);

/// What an error says of the choice between cases.
std::string choice_of_load_cases(const Structure& structure);

}  // namespace kusabi::problems
