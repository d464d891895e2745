// `kusabi critical FILE`: the smallest friction coefficient at which anything can wedge, with a
// proved bracket: by one global search, or pattern by pattern (Algorithm 6.1 of the paper).
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

struct CriticalOptions {
  std::string file;  ///< the problem
  wedged::CriticalQuestion question;
  std::uint64_t top = std::numeric_limits<std::uint64_t>::max();  ///< so many in the table
  std::string certificate;  ///< evidence of both ends goes to NAME.lower and NAME.upper
  engine::Limits limits;    ///< where to stop early
  CheckpointChoice checkpoint;
};

std::unique_ptr<Subcommand> critical_subcommand();

}  // namespace kusabi::run
