// `kusabi hold FILE`: states of equilibrium under load. Without --mu the smallest friction
// coefficient at which the dead load can be held; with it the factors of the reference load that
// can be held in addition.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "engine/options.hpp"
#include "nodes/wedged/hold/diagram.hpp"
#include "nodes/wedged/hold/grip_search.hpp"
#include "nodes/wedged/hold/hold_search.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"

namespace kusabi::run {

struct HoldOptions {
  ProblemInput input;
  std::vector<double> points;  ///< friction coefficients; none: the smallest one is requested
  std::string load_case;
  wedged::HoldParameters parameters;
  bool grip = false;                 ///< the grip range is requested
  bool diagram = false;              ///< pairs of factors of two load cases are requested
  std::vector<std::string> cases{};  ///< with `diagram`: names of both
  std::string certificate;           ///< file name; empty: none
  engine::Limits limits;
  CheckpointChoice checkpoint;
};

/// Factors that are held at one friction coefficient.
struct HeldPoint {
  double mu = 0;
  wedged::HeldFactors factors{};
  std::optional<wedged::GripRange> grip{};

  [[nodiscard]] engine::Status status() const {
    return grip && grip->status != engine::Status::solved ? grip->status : factors.status;
  }
  [[nodiscard]] std::vector<wedged::HoldCost> costs() const {
    auto all = factors.costs;
    if (grip) all.insert(all.end(), grip->costs.begin(), grip->costs.end());
    return all;
  }
};

/// `friction` or `diagram` is present after the search, or there are points.
struct HoldFindings {
  std::optional<wedged::HoldingFriction> friction{};
  std::vector<HeldPoint>
      points{};            ///< of the options, in their order; of several, only complete ones
  bool certified = false;  ///< a certificate of factors was written
  std::optional<wedged::Diagram> diagram{};
  engine::Status ended = engine::Status::solved;  ///< of the points
  std::vector<wedged::HoldCost> costs_left{};     ///< of a point that is not complete

  [[nodiscard]] engine::Status status() const {
    if (friction) return friction->status;
    if (diagram) return diagram->status;
    return ended;
  }
  [[nodiscard]] std::vector<wedged::HoldCost> costs() const {
    if (friction) return friction->costs;
    if (diagram) return diagram->costs;
    std::vector<wedged::HoldCost> all;
    for (const auto& point : points) std::ranges::move(point.costs(), std::back_inserter(all));
    std::ranges::copy(costs_left, std::back_inserter(all));
    return all;
  }
};

}  // namespace kusabi::run
