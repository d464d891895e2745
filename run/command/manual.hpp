// Manual pages from the tables, in the language of man(7).
#pragma once

#include <string>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// kusabi.1: every option of every subcommand.
std::string manual(const CommandList& list);

/// The page of one subcommand: kusabi-patterns.1.
std::string manual(const CommandList& list, const CommandList::Entry& entry);

}  // namespace kusabi::run
