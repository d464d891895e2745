// `kusabi critical FILE`: the smallest friction coefficient at which anything can wedge, with a
// proved bracket: by one global search, or pattern by pattern (Algorithm 6.1 of the paper).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/critical_findings.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

using wedged::CriticalWay;

struct CriticalOptions {
  std::string file;  ///< the problem
  CriticalWay way = CriticalWay::global;
  std::optional<double> most;  ///< no larger coefficient is of interest; mu^0 of the paper
  double width = 1e-8;         ///< of the brackets
  std::string certificate;     ///< evidence of both ends goes to NAME.lower and NAME.upper
  engine::Limits limits;       ///< where to stop early
  bool quiet = false;          ///< nothing is shown while it works
};

std::unique_ptr<Subcommand> critical_subcommand();

}  // namespace kusabi::run
