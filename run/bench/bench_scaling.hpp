// `kusabi bench scaling`: speedup of the search on many ranks, by simulation in virtual time.
#pragma once

#include <cstdint>
#include <string>

#include "engine/transport/simulated.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

struct BenchScalingOptions {
  std::string trace;                       ///< file of a recorded tree; empty: none
  std::string tree = "sized";              ///< or a standard tree, if no trace is given
  std::uint64_t nodes = 100'000'000;       ///< nodes of the tree `sized`
  double node_microseconds = 10;           ///< time to open a node, unless it is recorded
  double latency_microseconds = 2;         ///< latency of a message between machines
  double near_latency_microseconds = 0.5;  ///< the same inside a machine
  int machine = 1;                         ///< ranks on one machine
  double handling_microseconds = 0.5;      ///< time per message of its sender, and of its receiver
  double gigabytes_per_second = 10;        ///< bandwidth
  int min_ranks = 1;
  int max_ranks = 65536;  ///< largest number of ranks; four times as many in each row
  std::uint64_t seed = 1;
};

/// Runs the command. @return the exit code
int bench_scaling(Session& session, const BenchScalingOptions& options);

}  // namespace kusabi::run
