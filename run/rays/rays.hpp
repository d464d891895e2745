// `kusabi rays FILE --mu MU`: all extremal rays and maximal cones of wedged configurations in the
// plane (Algorithms 4.1 to 4.3 of the paper).
#pragma once

#include <memory>
#include <string>

#include "engine/options.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

/// How rays are found. Both ways find the same.
enum class RayMethod {
  automatic,           ///< whichever of the two is expected to be faster
  double_description,  ///< Algorithm 4.2, on one rank
  tree,                ///< pattern by pattern, on all ranks
};

struct RaysOptions {
  std::string file;     ///< the problem
  double friction = 0;  ///< mu
  RayMethod method = RayMethod::automatic;
  engine::Limits limits;  ///< where to stop early; RayMethod::tree only
};

std::unique_ptr<Subcommand> rays_subcommand();

}  // namespace kusabi::run
