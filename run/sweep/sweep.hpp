// `kusabi sweep FILE --mu …`: how the number of sign patterns grows with friction, exact between
// the points; `kusabi sweep FILE --alpha …`: how the worst-case limit load falls as the loads
// become less certain, likewise.
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

std::unique_ptr<Subcommand> sweep_subcommand();

}  // namespace kusabi::run
