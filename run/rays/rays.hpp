// `kusabi rays FILE --mu MU`: all extremal rays and maximal cones of wedged configurations in the
// plane (Algorithms 4.1 to 4.3 of the paper).
#pragma once

#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/ray_search.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

using wedged::RayMethod;

struct RaysOptions {
  std::string file;     ///< the problem
  double friction = 0;  ///< mu
  RayMethod method = RayMethod::automatic;
  std::string output;     ///< the result file; empty: none
  std::string csv;        ///< the rays as a table; empty: nowhere
  std::string dot;        ///< the cross-complementarity graph; empty: nowhere
  engine::Limits limits;  ///< where to stop early; RayMethod::tree only
  bool quiet = false;     ///< no progress, no table
};

/// Runs the command on all ranks. @return the exit code
/// @throws WrongInput, support::InputError on every rank alike
int rays(Session& session, const RaysOptions& options);

}  // namespace kusabi::run
