// Which subcommands there are.
#pragma once

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// All of them.
CommandList command_list();

}  // namespace kusabi::run
