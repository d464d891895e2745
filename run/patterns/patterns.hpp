// `kusabi patterns FILE --mu MU`: all sign patterns of wedged configurations (Algorithms 5.1, 5.8
// of the wedged paper).
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"

namespace kusabi::run {

/// Words of --branching.
const OptionWords<wedged::Branching>& branching_words();

/// Order of the table. A pattern keeps its number, which result files and pictures use.
enum class PatternSort {
  number,    ///< order of the tree
  margin,    ///< largest margin first
  contact,   ///< fewest candidates in contact first
  critical,  ///< smallest critical friction coefficient first
};

struct PatternsOptions {
  ProblemInput input;
  double friction = 0;  ///< friction coefficient mu
  /// Of the search; complete after Subcommand::prepare().
  wedged::PatternParameters parameters;
  bool polyhedral = false;       ///< Algorithm 5.8; otherwise Algorithm 5.1
  int facets = 16;               ///< facets of the polyhedral friction cones of Algorithm 5.8
  bool list_candidates = false;  ///< lists the candidates of Algorithm 5.8 in the table
  PatternSort sort = PatternSort::number;
  /// Maximum number of candidates in which patterns of a group differ; 0: no groups; negative:
  /// groups on a terminal if the table would be long.
  int group = -1;
  std::uint64_t top = std::numeric_limits<std::uint64_t>::max();  ///< maximum number of rows
  engine::Limits limits;                                          ///< limits of the search
  CheckpointChoice checkpoint;                                    ///< files of its state
  std::string certificate;                                        ///< certificate file; empty: none
  bool whole = false;  ///< whole state of every pattern in the result file
  bool lines = false;  ///< result file with one line per pattern
  std::string trace;   ///< timeline file; empty: none
  std::string record;  ///< file of the nodes, for bench scaling; empty: none
  std::string vtu;     ///< folder of pictures; empty: none
};

}  // namespace kusabi::run
