// Which subcommands there are.
#pragma once

#include "run/command/command_line.hpp"

namespace kusabi::run {

/// All of them, in the order of help.
CommandLine command_line();

}  // namespace kusabi::run
