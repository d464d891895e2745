// `kusabi draw RESULT`: answers of a result file as an SVG image.
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

std::unique_ptr<Subcommand> draw_subcommand();

}  // namespace kusabi::run
