// Completion scripts for shells, generated from the option tables: subcommands, options, choices
// and names of files.
#pragma once

#include <string>
#include <string_view>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// @param shell "bash", "zsh" or "fish" @throws WrongCall for any other
std::string completion(const CommandList& list, std::string_view shell);

}  // namespace kusabi::run
