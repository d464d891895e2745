// `kusabi bench scaling`: how far the search scales, by simulation in virtual time.
#pragma once

#include <cstdint>

#include "engine/transport/simulated.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

struct BenchScalingOptions {
  std::uint64_t nodes = 100'000'000;   ///< of the tree
  double node_microseconds = 10;       ///< to open one
  double latency_microseconds = 2;     ///< of a message
  double handling_microseconds = 0.5;  ///< that a message costs its sender, and its receiver
  double gigabytes_a_second = 10;      ///< bandwidth
  int least_ranks = 1;
  int most_ranks = 65536;  ///< four times as many in each row
  std::uint64_t seed = 1;
};

/// Runs the command. @return the exit code
int bench_scaling(Session& session, const BenchScalingOptions& options);

}  // namespace kusabi::run
