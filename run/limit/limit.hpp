// `kusabi limit FILE`: collapse load factor of a truss ((5) of the limit paper), and with `--alpha`
// its least value under uncertain dead loads ((13)).
#pragma once

#include <string>

#include "engine/options.hpp"
#include "nodes/limit/model/limit_parameters.hpp"
#include "problems/limit/half_widths.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"
#include "run/limit/loss_options.hpp"

namespace kusabi::run {

/// Words of --cuts.
const OptionWords<limit::LimitMethod>& limit_method_words();

struct LimitOptions {
  ProblemInput input;
  std::string load_case;   ///< requested load case; empty: all
  std::string curve_load;  ///< file of the load of a curve
  problems::RequestedHalfWidths asked;
  limit::LimitParameters parameters;  ///< its alpha follows from `asked` and the file
  engine::Limits limits;              ///< limits of the tree search
  LossOptions loss;
  CheckpointChoice checkpoint;
};

}  // namespace kusabi::run
