// `kusabi rays FILE --mu MU`: all extremal rays and maximal cones of wedged configurations in the
// plane (Algorithms 4.1 to 4.3 of the wedged paper).
#pragma once

#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/rays/ray_search.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"

namespace kusabi::run {

struct RaysOptions {
  ProblemInput input;
  double friction = 0;  ///< friction coefficient mu
  wedged::RayMethod method = wedged::RayMethod::automatic;
  bool lines = false;     ///< the result file in lines, written during the search
  bool whole = false;     ///< all displacements and support reactions in the result file
  bool prove = false;     ///< comparison of the cones with a proved list of patterns
  engine::Limits limits;  ///< limits of the search; wedged::RayMethod::tree only
  CheckpointChoice checkpoint;
};

}  // namespace kusabi::run
