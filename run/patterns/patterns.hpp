// `kusabi patterns FILE --mu MU`: all sign patterns of wedged configurations (Algorithms 5.1, 5.8).
#pragma once

#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/sign_pattern.hpp"
#include "run/session/session.hpp"
#include "solvers/conic/node_solver.hpp"

namespace kusabi::run {

struct PatternsOptions {
  std::string file;                                           ///< the problem
  double friction = 0;                                        ///< mu
  double tolerance = conic::Tolerances{}.sign;                ///< |t*| up to this is marginal
  wedged::Branching branching = wedged::Branching::relative;  ///< how nodes are split
  int facets = 0;          ///< of the polyhedral friction cones of Algorithm 5.8; 0: Algorithm 5.1
  std::string output;      ///< the result file; empty: none
  engine::Limits limits;   ///< where to stop early
  std::string checkpoint;  ///< keep the state here; empty: nowhere
  double checkpoint_interval = 600;  ///< seconds
  std::string restart;               ///< go on from here; empty: start anew
  std::string trace;                 ///< the timeline goes here
  std::string certificate;           ///< the evidence goes here; empty: nowhere
  bool quiet = false;                ///< no progress, no table
};

/// Runs the command on all ranks. @return the exit code
/// @throws WrongInput, support::InputError on every rank alike
int patterns(Session& session, const PatternsOptions& options);

}  // namespace kusabi::run
