// `kusabi limit FILE`: the load factor at which a truss collapses (limit paper (5)), and with
// `--alpha` the least one that an uncertain dead load can bring about ((13)).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/options.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

/// How the worst case is found.
enum class LimitMethod {
  fixed,        ///< the 0-1 program (29) by Algorithm 4.2, as it is
  disjunctive,  ///< with the cuts of Algorithm 5.1: the paper's method
  tightened,    ///< with M made as small as can be by optimisation
  static_cuts,  ///< static cuts and the tree of signs: neither (29) nor M
  all,          ///< (29) with static cuts as rows, tightened M, and disjunctive cuts
};

struct LimitOptions {
  std::string file;
  std::optional<double> alpha;  ///< half-width of the uncertain components; nothing: nominal only
  LimitMethod method = LimitMethod::static_cuts;
  std::optional<double> big_m;  ///< M of (29), in the paper's units; nothing: derived
  std::uint64_t samples = 0;    ///< random dead loads to compare with
  std::uint64_t seed = 1;       ///< of those
  bool curve = false;           ///< how the factor falls as the uncertainty grows
  engine::Limits limits;        ///< where the search of a tree stops early
  bool quiet = false;           ///< nothing is shown while it works
};

std::unique_ptr<Subcommand> limit_subcommand();

}  // namespace kusabi::run
