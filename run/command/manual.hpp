// Manual pages in the language of man(7), generated from the option tables.
#pragma once

#include <string>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// kusabi.1: all options of all subcommands.
std::string manual(const CommandList& list);

/// The page of one subcommand: kusabi-patterns.1.
std::string manual(const CommandList& list, const CommandList::Entry& entry);

}  // namespace kusabi::run
