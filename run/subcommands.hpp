// All subcommands.
#pragma once

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// A new list of all subcommands with their option tables, in the order of `kusabi help`.
CommandList command_list();

}  // namespace kusabi::run
