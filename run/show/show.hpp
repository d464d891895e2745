// `kusabi show FILE`: what a problem file describes, before anything is solved.
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

std::unique_ptr<Subcommand> show_subcommand();

}  // namespace kusabi::run
