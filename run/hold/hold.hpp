// `kusabi hold FILE`: states of equilibrium under load. Without --mu the smallest friction
// coefficient at which the dead load can be held; with it the factors of the reference load that
// can be held in addition.
#pragma once

#include <optional>
#include <string>

#include "engine/options.hpp"
#include "nodes/wedged/hold/hold_search.hpp"
#include "run/command/problem_input.hpp"

namespace kusabi::run {

struct HoldOptions {
  ProblemInput input;
  std::optional<double> mu;  ///< absent: the smallest coefficient is requested
  std::string load_case;
  wedged::HoldQuestion question;
  engine::Limits limits;
};

/// One of both is present after the search.
struct HoldFindings {
  std::optional<wedged::HoldingFriction> friction{};
  std::optional<wedged::HeldFactors> factors{};

  [[nodiscard]] engine::Status status() const {
    return friction ? friction->status : factors ? factors->status : engine::Status::solved;
  }
  [[nodiscard]] const std::vector<wedged::HoldCost>& costs() const {
    return friction ? friction->costs : factors->costs;
  }
};

}  // namespace kusabi::run
