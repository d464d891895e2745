// `kusabi import DECK`: the problem file that a deck of Abaqus or CalculiX describes.
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

std::unique_ptr<Subcommand> import_subcommand();

}  // namespace kusabi::run
