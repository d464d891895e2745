// Scripts that let a shell complete calls of kusabi, from the tables: subcommands, options, choices
// and names of files.
#pragma once

#include <string>
#include <string_view>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// @param shell "bash", "zsh" or "fish"
/// @throws WrongCall if it is another
std::string completion(const CommandList& list, std::string_view shell);

}  // namespace kusabi::run
