// `kusabi bench`: measurements and tests of the search engine.
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

std::unique_ptr<Subcommand> bench_scaling_subcommand();
std::unique_ptr<Subcommand> bench_schedules_subcommand();
std::unique_ptr<Subcommand> bench_uts_subcommand();

}  // namespace kusabi::run
