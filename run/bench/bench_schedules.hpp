// `kusabi bench schedules`: does the protocol hold under any schedule of messages?
#pragma once

#include <cstdint>

#include "run/session/session.hpp"

namespace kusabi::run {

struct BenchSchedulesOptions {
  std::uint64_t seeds = 10'000;  ///< schedules to try; under mpirun the ranks deal them out
  std::uint64_t first_seed = 1;
};

/// Simulates one search a seed, on a machine, a tree and with a goal drawn from the seed, and
/// compares it with the search on one rank. @return the exit code; 1 if any search differs, with
/// one line each
int bench_schedules(Session& session, const BenchSchedulesOptions& options);

}  // namespace kusabi::run
