// All subcommands.
#pragma once

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// Makes the list.
CommandList command_list();

}  // namespace kusabi::run
