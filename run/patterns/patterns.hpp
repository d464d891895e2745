// `kusabi patterns FILE --mu MU`: all sign patterns of wedged configurations (Algorithms 5.1, 5.8).
#pragma once

#include <memory>
#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/sign_pattern.hpp"
#include "run/command/subcommand.hpp"
#include "solvers/conic/node_solver.hpp"

namespace kusabi::run {

struct PatternsOptions {
  std::string file;                                            ///< the problem
  double friction = 0;                                         ///< mu
  double tolerance = conic::Tolerances{}.sign;                 ///< |t*| up to this is marginal
  wedged::Branching branching = wedged::Branching::automatic;  ///< how nodes are split
  bool polyhedral = false;                                     ///< Algorithm 5.8, otherwise 5.1
  int facets = 16;               ///< of the polyhedral friction cones of Algorithm 5.8
  bool list_candidates = false;  ///< of Algorithm 5.8, in the table
  engine::Order order = engine::Order::depth_first;
  engine::Limits limits;        ///< where to stop early
  CheckpointChoice checkpoint;  ///< where the state is kept
  std::string certificate;      ///< the evidence goes here; empty: nowhere

  /// Of polyhedral cones; 0: the cones themselves.
  [[nodiscard]] int facets_in_use() const { return polyhedral ? facets : 0; }
};

std::unique_ptr<Subcommand> patterns_subcommand();

}  // namespace kusabi::run
