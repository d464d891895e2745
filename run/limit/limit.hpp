// `kusabi limit FILE`: the load factor at which a truss collapses (limit paper (5)), and with
// `--alpha` the least one that an uncertain dead load can bring about ((13)).
#pragma once

#include <memory>
#include <string>

#include "engine/options.hpp"
#include "nodes/limit/limit_question.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

struct LimitOptions {
  std::string file;
  std::optional<double> alpha;  ///< half-width of the uncertain components; nothing: nominal only
  LimitMethod method = LimitMethod::static_cuts;
  std::optional<double> big_m;  ///< M of (29), in the paper's units; nothing: derived
  std::uint64_t samples = 0;    ///< random dead loads to compare with
  std::uint64_t seed = 1;       ///< of those
  bool curve = false;           ///< how the factor falls as the uncertainty grows
  engine::Limits limits;        ///< where the search of a tree stops early
};

std::unique_ptr<Subcommand> limit_subcommand();

}  // namespace kusabi::run
