// `kusabi mip FILE`: the optimum of a mixed zero-one linear program, with the bound that shows it
// (Algorithms 4.2 and 5.1 of the limit paper).
#pragma once

#include <memory>
#include <string>

#include "engine/options.hpp"
#include "nodes/zero_one/root.hpp"
#include "nodes/zero_one/tree.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

struct MipOptions {
  std::string file;                                          ///< the program, MPS or CPLEX LP
  zero_one::ZeroOneCuts cuts = zero_one::ZeroOneCuts::none;  ///< at the root
  zero_one::ZeroOneBranching branching = zero_one::ZeroOneBranching::paper;
  bool tighten = true;                               ///< big Ms, by optimisation
  bool dive = true;                                  ///< for points, at the root
  engine::Order order = engine::Order::depth_first;  ///< which node is next
  engine::Limits limits;                             ///< where to stop early
  CheckpointChoice checkpoint;                       ///< where the state is kept
};

std::unique_ptr<Subcommand> mip_subcommand();

}  // namespace kusabi::run
