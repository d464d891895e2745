// `kusabi bench uts --tree T1`: the Unbalanced Tree Search benchmark; compares the counts with the
// published ones, and the CPU time of a node with that of a plain recursion.
#pragma once

#include <string>

#include "run/session/session.hpp"

namespace kusabi::run {

struct BenchUtsOptions {
  std::string tree = "T1";  ///< name of a tree in benchmark::standard_trees
  unsigned work = 1;        ///< hashes per node, about 0.1 microseconds each
  unsigned rounds = 5;      ///< number of recursions and searches over the whole tree
};

/// Runs the command on all ranks.
/// @return the exit code: `failed` if the counts are not the published ones
/// @throws std::out_of_range if there is no tree of that name
int bench_uts(Session& session, const BenchUtsOptions& options);

}  // namespace kusabi::run
