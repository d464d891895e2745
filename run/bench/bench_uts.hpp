// `kusabi bench uts --tree T1`: the Unbalanced Tree Search benchmark. Are the published counts
// found, and how much CPU time does the engine cost beside a plain recursion?
#pragma once

#include <string>

#include "run/session/session.hpp"

namespace kusabi::run {

struct BenchUtsOptions {
  std::string tree = "T1";  ///< a name in benchmark::standard_trees
  unsigned work = 1;        ///< hashes a node; one takes about 0.1 microseconds
  unsigned rounds = 5;      ///< recursions and searches in turn, of which the fastest count
};

/// Runs the command on all ranks. @return the exit code: `failed` if the counts are not the
///   published ones
/// @throws std::out_of_range if there is no tree of that name
int bench_uts(Session& session, const BenchUtsOptions& options);

}  // namespace kusabi::run
