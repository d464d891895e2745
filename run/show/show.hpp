// `kusabi show FILE`: contents of a problem file, without solving it.
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

std::unique_ptr<Subcommand> show_subcommand();

}  // namespace kusabi::run
