// `kusabi critical FILE`: the smallest friction coefficient with a wedged configuration, in a
// proved bracket, by one global search or pattern by pattern (Algorithm 6.1 of the wedged paper).
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"

namespace kusabi::run {

struct CriticalOptions {
  ProblemInput input;
  wedged::CriticalParameters parameters;
  std::uint64_t top = std::numeric_limits<std::uint64_t>::max();  ///< maximum number of rows
  bool whole = false;       ///< whole state of every pattern in the result file
  std::string certificate;  ///< certificates of both bounds: NAME.lower and NAME.upper
  engine::Limits limits;    ///< limits of the search
  CheckpointChoice checkpoint;
};

}  // namespace kusabi::run
