// Holding friction coefficient of a block: trees at coefficients from 0 on, and the coefficient of
// a leaf by bisection.
#include <algorithm>
#include <array>
#include <cmath>

#include "nodes/wedged/hold/block_hold.hpp"

namespace kusabi::wedged {
namespace {

/// Relative steps below a leaf's own coefficient at which the tree is searched if it is degenerate
/// there.
constexpr std::array<double, 4> steps_below{0, 1e-8, 1e-6, 1e-4};

/// The least friction factor that is not zero; infinite if there is none.
double min_of_factors(const problems::WedgedProblem& problem) {
  double minimum = unbounded_end;
  for (const double factor : problem.friction)
    if (factor > 0) minimum = std::min(minimum, factor);
  return minimum;
}

}  // namespace

// A proved lower bound at or below a coefficient at which the leaf itself is infeasible. False if
// another leaf has a state there, which is then the upper bound of the answer.
bool BlockHold::prove_lower(HoldingFriction& found, double max_infeasible) {
  const std::array share{LoadShare{1, 0}};
  for (const double step : steps_below) {
    const double mu = max_infeasible * (1 - step);
    const auto outcome = search(share, mu, 0, 0);
    if (outcome.status != engine::Status::solved) {
      found.status = outcome.status;
      return true;
    }
    if (!outcome.leaf.empty()) {
      found.upper = mu;
      found.pattern = outcome.leaf.front().pattern;
      return false;
    }
    found.lower = mu;
    found.lower_known = true;
    found.lower_proved = outcome.is_infeasible();
    if (found.lower_proved) return true;
  }
  return true;
}

// Bisects a range of coefficients in which leaves are degenerate, with one tree at each point. The
// lower end is proved only if the last tree there is infeasible, otherwise computed.
void BlockHold::narrow(HoldingFriction& found) {
  for (int step = 0; found.upper && step < max_halvings; ++step) {
    if (*found.upper - found.lower <= close_enough * *found.upper) return;
    const double mu = found.lower + (*found.upper - found.lower) / 2;
    if (mu * min_of_factors(block_.problem) < min_friction) return;
    const auto outcome = search(std::array{LoadShare{1, 0}}, mu, 0, 0);
    found.status = outcome.status;
    if (found.status != engine::Status::solved) return;
    if (!outcome.leaf.empty()) {
      found.upper = mu;
      found.pattern = outcome.leaf.front().pattern;
      continue;
    }
    found.lower = mu;
    found.lower_known = true;
    found.lower_proved = outcome.is_infeasible();
  }
}

HoldingFriction BlockHold::friction() {
  HoldingFriction found;
  const auto& factors = block_.problem.friction;
  double minimum = 0, maximum = 0;
  for (const double factor : factors) {
    if (factor > 0) minimum = std::max(minimum, min_friction / factor);
    maximum = std::max(maximum, factor);
  }
  found.maximum = maximum == 0 ? 0 : std::min(parameters_.maximum, max_friction / maximum);
  if (!first_bracket(found)) return found;
  follow(found, minimum);
  if (ended_ && found.status == engine::Status::solved) found.status = analysis_.stop_reason();
  if (found.status == engine::Status::solved) narrow(found);
  return found;
}

// Coefficients 0, 1, 10, ... up to the first at which a leaf has a state. False if nothing is left
// to bisect.
bool BlockHold::first_bracket(HoldingFriction& found) {
  const std::array share{LoadShare{1, 0}};
  const auto smooth = search(share, 0, 0, 0);
  found.status = smooth.status;
  if (found.status != engine::Status::solved) return false;
  const auto& limits = smooth.tally.limits;
  if (!smooth.leaf.empty() || !limits.empty()) {
    found.upper = 0;
    found.upper_proved = !smooth.leaf.empty();
    found.pattern = (found.upper_proved ? smooth.leaf.front() : limits.front()).pattern;
    return false;
  }
  found.lower_known = true;
  found.lower_proved = smooth.is_infeasible();
  for (double mu = std::min(1.0, found.maximum); mu > 0; mu = std::min(10 * mu, found.maximum)) {
    const auto outcome = search(share, mu, 0, 0);
    found.status = outcome.status;
    if (found.status != engine::Status::solved) return false;
    if (!outcome.leaf.empty()) {
      found.upper = mu;
      found.pattern = outcome.leaf.front().pattern;
      return true;
    }
    found.lower = mu;
    found.lower_proved = outcome.is_infeasible();
    if (mu >= found.maximum) return false;
  }
  return false;
}

// Follows the leaf of the upper bound to its own coefficient, until the tree below it is
// infeasible.
// @param minimum coefficient that is not zero
void BlockHold::follow(HoldingFriction& found, double minimum) {
  while (*found.upper > minimum) {
    HoldNodes nodes(block_, std::array{LoadShare{1, 0}}, *found.upper, parameters_.precision);
    const double start = std::max(found.lower, minimum);
    const auto result_at = [&](double mu) {
      nodes.set_friction(mu);
      return nodes.solve(*found.pattern);
    };
    if (start == minimum && result_at(minimum) == HoldResult::feasible) {
      found.upper = minimum;
      return;
    }
    const Ends ends = bisect({*found.upper, start}, 0, result_at);
    found.upper = ends.feasible;
    if (ends.infeasible <= found.lower || prove_lower(found, ends.infeasible)) return;
  }
}

}  // namespace kusabi::wedged
