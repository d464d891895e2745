// `kusabi mip FILE`: optimum of a mixed zero-one linear program and its proved bound (Algorithms
// 4.2 and 5.1 of the limit paper).
#pragma once

#include <string>

#include "engine/options.hpp"
#include "nodes/zero_one/root.hpp"
#include "nodes/zero_one/tree.hpp"
#include "run/command/option_table.hpp"

namespace kusabi::run {

/// Words of --cuts and --branching.
const OptionWords<zero_one::ZeroOneCuts>& root_cuts_words();
const OptionWords<zero_one::ZeroOneBranching>& zero_one_branching_words();

struct MipOptions {
  std::string file;                                          ///< the program, MPS or CPLEX LP
  zero_one::ZeroOneCuts cuts = zero_one::ZeroOneCuts::none;  ///< cuts at the root
  zero_one::ZeroOneBranching branching = zero_one::ZeroOneBranching::paper;
  bool tighten = true;  ///< coefficients M are tightened by optimisation
  bool dive = true;     ///< search for a first point at the root
  engine::Order order = engine::Order::depth_first;  ///< order of open nodes
  engine::Limits limits;                             ///< limits of the search
  CheckpointChoice checkpoint;                       ///< files of its state
};

}  // namespace kusabi::run
