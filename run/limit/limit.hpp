// `kusabi limit FILE`: collapse load factor of a truss ((5) of the limit paper), and with `--alpha`
// its least value under uncertain dead loads ((13)).
#pragma once

#include <string>

#include "engine/options.hpp"
#include "nodes/limit/model/limit_parameters.hpp"
#include "problems/limit/half_widths.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"

namespace kusabi::run {

struct LimitOptions {
  ProblemInput input;
  std::string load_case;   ///< requested load case; empty: all
  std::string curve_load;  ///< file of the load of a curve
  problems::RequestedHalfWidths asked;
  limit::LimitParameters parameters;         ///< its alpha follows from `asked` and the file
  engine::Limits limits;                     ///< limits of the tree search
  limit::LossParameters loss{.maximum = 0};  ///< 0: the loss of members is not requested
  std::string kept;                          ///< nodes and members, as in the call
  CheckpointChoice checkpoint;
};

}  // namespace kusabi::run
