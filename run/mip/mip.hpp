// `kusabi mip FILE`: the optimum of a mixed zero-one linear program, with the bound that shows it
// (Algorithms 4.2 and 5.1 of the limit paper).
#pragma once

#include <string>

#include "engine/options.hpp"
#include "nodes/zero_one/root.hpp"
#include "nodes/zero_one/tree.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

struct MipOptions {
  std::string file;                                          ///< the program, MPS or CPLEX LP
  zero_one::ZeroOneCuts cuts = zero_one::ZeroOneCuts::none;  ///< at the root
  zero_one::ZeroOneBranching branching = zero_one::ZeroOneBranching::paper;
  bool tighten = true;                               ///< big Ms, by optimisation
  bool dive = true;                                  ///< for points, at the root
  engine::Order order = engine::Order::depth_first;  ///< which node is next
  engine::Limits limits;                             ///< where to stop early
  std::string output;                                ///< the result file; empty: none
  std::string checkpoint;                            ///< keep the state here; empty: nowhere
  double checkpoint_interval = 600;                  ///< seconds
  std::string restart;                               ///< go on from here; empty: start anew
  bool quiet = false;                                ///< no progress, no table
};

/// Runs the command on all ranks. @return the exit code
/// @throws WrongInput, support::InputError on every rank alike
int mip(Session& session, const MipOptions& options);

}  // namespace kusabi::run
