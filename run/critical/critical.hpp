// `kusabi critical FILE`: the smallest friction coefficient at which anything can wedge, with a
// proved bracket: by one global search, or pattern by pattern (Algorithm 6.1 of the paper).
#pragma once

#include <optional>
#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/critical_findings.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

using wedged::CriticalWay;

struct CriticalOptions {
  std::string file;  ///< the problem
  CriticalWay way = CriticalWay::global;
  std::optional<double> most;  ///< no larger coefficient is of interest; mu^0 of the paper
  double width = 1e-8;         ///< of the brackets
  std::string output;          ///< the result file; empty: none
  std::string certificate;     ///< evidence of both ends goes to NAME.lower and NAME.upper
  engine::Limits limits;       ///< where to stop early
  bool quiet = false;          ///< no progress, no table
};

/// Runs the command on all ranks. @return the exit code
/// @throws WrongInput, support::InputError on every rank alike
int critical(Session& session, const CriticalOptions& options);

}  // namespace kusabi::run
