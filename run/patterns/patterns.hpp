// `kusabi patterns FILE --mu MU`: all sign patterns of wedged configurations (Algorithms 5.1, 5.8).
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "run/command/subcommand.hpp"
#include "solvers/conic/node_solver.hpp"

namespace kusabi::run {

/// How the table is ordered. A pattern keeps its number, by which result files and pictures know
/// it.
enum class PatternSort {
  number,    ///< as the tree has them
  margin,    ///< the largest first
  contact,   ///< the fewest candidates in contact first
  critical,  ///< those that begin to live at the least friction first
};

struct PatternsOptions {
  std::string file;                                               ///< the problem
  double friction = 0;                                            ///< mu
  double tolerance = conic::Tolerances{}.sign;                    ///< |t*| up to this is marginal
  wedged::Tightening tightening = wedged::Tightening::automatic;  ///< whether there are cuts
  wedged::Branching branching = wedged::Branching::automatic;     ///< how nodes are split
  int probes = 0;           ///< of how many candidates children are tried before a node is split
  bool polyhedral = false;  ///< Algorithm 5.8, otherwise 5.1
  int facets = 16;          ///< of the polyhedral friction cones of Algorithm 5.8
  bool list_candidates = false;  ///< of Algorithm 5.8, in the table
  PatternSort sort = PatternSort::number;
  /// Patterns that differ in so many candidates are one line; 0: no groups; negative: the table
  /// of a terminal has some if it would be long.
  int group = -1;
  std::uint64_t top = std::numeric_limits<std::uint64_t>::max();  ///< so many of them in the table
  engine::Order order = engine::Order::depth_first;
  engine::Limits limits;        ///< where to stop early
  CheckpointChoice checkpoint;  ///< where the state is kept
  std::string certificate;      ///< the evidence goes here; empty: nowhere
  bool prove = false;           ///< whether every node is put to the exact test

  /// Of polyhedral cones; 0: the cones themselves.
  [[nodiscard]] int facets_in_use() const { return polyhedral ? facets : 0; }
};

std::unique_ptr<Subcommand> patterns_subcommand();

}  // namespace kusabi::run
