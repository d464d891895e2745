// `kusabi sweep FILE --mu …`: number of sign patterns over the friction coefficient, exact between
// points; `kusabi sweep FILE --alpha …`: worst-case limit load over the uncertainty of loads.
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

std::unique_ptr<Subcommand> sweep_subcommand();

}  // namespace kusabi::run
