// Manual pages in the language of man(7), generated from the option tables.
#pragma once

#include <string>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// kusabi.1: all subcommands in a line each, options of `kusabi` itself, examples, files.
std::string manual(const CommandList& list);

/// The page of one subcommand: kusabi-patterns.1.
std::string manual(const CommandList& list, const CommandList::Entry& entry);

/// The page of a group, which lists its subcommands: kusabi-bench.1.
std::string manual(const CommandList& list, const CommandList::Group& group);

}  // namespace kusabi::run
