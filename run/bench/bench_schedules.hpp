// `kusabi bench schedules`: tests of the protocol under random schedules of messages.
#pragma once

#include <cstdint>

#include "run/session/session.hpp"

namespace kusabi::run {

struct BenchSchedulesOptions {
  std::uint64_t seeds = 10'000;  ///< number of schedules, divided among the ranks under mpirun
  std::uint64_t first_seed = 1;
};

/// Simulates one search per seed, with machine, tree and goal drawn from the seed, and compares it
/// with the search on one rank.
/// @return the exit code; 1 if any search differs, with one line each
int bench_schedules(Session& session, const BenchSchedulesOptions& options);

}  // namespace kusabi::run
