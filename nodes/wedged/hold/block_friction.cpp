// Holding friction coefficient of a block: trees at coefficients from 0 on, and the coefficient of
// a leaf by bisection.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "nodes/wedged/hold/block_hold.hpp"

namespace kusabi::wedged {
namespace {

/// Relative steps below a leaf's own coefficient at which the tree is searched if it is degenerate
/// there.
constexpr std::array<double, 4> steps_below{0, 1e-8, 1e-6, 1e-4};

/// Relative step above the coefficient that statics needs at which the first tree is searched: near
/// enough for the pattern to be that of the end, far enough for its nodes to be solved in doubles.
constexpr double beside_statics = 1e-3;

/// The least friction factor that is not zero; infinite if there is none.
double min_of_factors(const problems::WedgedProblem& problem) {
  double minimum = unbounded_end;
  for (const double factor : problem.friction)
    if (factor > 0) minimum = std::min(minimum, factor);
  return minimum;
}

}  // namespace

// Takes a state of a tree at a coefficient as the upper bound: a proved one, or one at a limit.
// False if it has none.
bool BlockHold::take_upper(HoldingFriction& found, const HoldOutcome& outcome, double mu) {
  const bool proved = !outcome.leaves.empty();
  if (!proved && outcome.tally.limits.empty()) return false;
  found.bracket.upper = support::Bound{mu, support::proved_if(proved)};
  found.pattern = (proved ? outcome.leaves.front() : outcome.tally.limits.front()).pattern;
  return true;
}

// Takes a tree without a state at a coefficient as the lower bound: a proved one if all its nodes
// are infeasible, a computed one if some are degenerate, none if some are undecided.
void BlockHold::take_lower(HoldingFriction& found, const HoldOutcome& outcome, double mu) {
  if (outcome.is_unresolved()) return;
  found.bracket.lower = support::Bound{mu, support::proved_if(outcome.is_infeasible())};
}

// A proved lower bound at or below a coefficient at which the leaf itself is infeasible. False if
// another leaf has a state there, which is then the upper bound of the answer: one at a limit only
// if nothing is proved somewhat below either.
bool BlockHold::prove_lower(HoldingFriction& found, double max_infeasible) {
  const std::array share{LoadShare{1, 0}};
  const HoldingFriction before = found;
  for (const double step : steps_below) {
    const double mu = max_infeasible * (1 - step);
    if (step > 0 && mu * min_of_factors(block_.problem) < min_friction) return true;
    const auto outcome = search(share, mu, 0, 0);
    if (outcome.status != engine::Status::solved) {
      found.status = outcome.status;
      return true;
    }
    const bool last = step == steps_below.back();
    if (!outcome.leaves.empty() || (last && !outcome.tally.limits.empty())) {
      found = before;
      return !take_upper(found, outcome, mu);
    }
    take_lower(found, outcome, mu);
    if (outcome.is_infeasible()) return true;
  }
  return true;
}

// Bisects a range of coefficients in which leaves are degenerate, with one tree at each point. A
// narrow range between proved bounds may remain undecided. Otherwise a state at a limit is an upper
// bound that is computed, and a tree with neither a state nor a proof a lower one.
void BlockHold::narrow(HoldingFriction& found) {
  const auto& [lower, upper] = found.bracket;
  if (!upper) return;
  const bool proved = found.bracket.proved_within(2 * steps_below.back() * upper->value);
  double low = lower ? lower->value : 0;  // also where nodes are undecided
  double open = upper->value;             // least undecided coefficient, or the upper bound
  double last_open = open;                // the largest one
  for (int step = 0; step < max_halvings; ++step) {
    const bool below = open - low > close_enough * open;
    if (!below && upper->value - last_open <= close_enough * upper->value) return;
    const double from = below ? low : last_open;
    const double mu = from + ((below ? open : upper->value) - from) / 2;
    if (mu * min_of_factors(block_.problem) < min_friction) return;
    const auto outcome = search(std::array{LoadShare{1, 0}}, mu, 0, 0);
    found.status = outcome.status;
    if (found.status != engine::Status::solved) return;
    const bool is_open = proved && outcome.leaves.empty() && !outcome.is_infeasible();
    if (is_open) {
      if (!below || open == upper->value) last_open = mu;
      if (below) open = mu;
      continue;
    }
    if (take_upper(found, outcome, mu)) {
      if (below) open = last_open = mu;
      continue;
    }
    take_lower(found, outcome, mu);
    low = mu;
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
  if (maximum == 0) {  // one tree is that of all coefficients
    found.maximum = parameters_.maximum;
    const std::array share{LoadShare{1, 0}};
    const auto smooth = search(share, found.maximum, 0, 0);
    found.status = smooth.status;
    if (found.status == engine::Status::solved && !take_upper(found, smooth, 0))
      take_lower(found, smooth, found.maximum);
    return found;
  }
  found.maximum = std::min(parameters_.maximum, max_friction / maximum);
  expected_ = by_first_rank([&](const support::Stop& stop) {
    return static_friction(block_, minimum, found.maximum, stop);
  });
  if (!first_bracket(found)) return found;
  follow(found, minimum);
  if (ended_ && found.status == engine::Status::solved) found.status = analysis_.stop_reason();
  if (found.status == engine::Status::solved) narrow(found);
  return found;
}

// Coefficients 0, the one that statics needs, 1, 10, ... up to the first at which a leaf has a state.
// False if nothing is left to bisect.
bool BlockHold::first_bracket(HoldingFriction& found) {
  const std::array share{LoadShare{1, 0}};
  const auto smooth = search(share, 0, 0, 0);
  found.status = smooth.status;
  if (found.status != engine::Status::solved) return false;
  if (take_upper(found, smooth, 0)) return false;
  take_lower(found, smooth, 0);
  std::vector<double> trials;
  if (expected_) trials.push_back(std::min(*expected_ * (1 + beside_statics), found.maximum));
  for (double mu = 1; mu < found.maximum; mu *= 10) trials.push_back(mu);
  trials.push_back(found.maximum);
  for (const double mu : trials) {
    if (mu <= found.bracket.at_least()) continue;
    const auto outcome = search(share, mu, 0, 0);
    found.status = outcome.status;
    if (found.status != engine::Status::solved) return false;
    // States at a limit so near the end of statics say nothing of those at larger coefficients.
    const bool beside = expected_ && mu == trials.front() && mu < found.maximum;
    if (beside && outcome.leaves.empty() && !outcome.is_infeasible()) continue;
    if (take_upper(found, outcome, mu)) return true;
    take_lower(found, outcome, mu);
  }
  return false;
}

// Follows the leaf of the upper bound to its own coefficient, until the tree below it is
// infeasible.
// @param minimum coefficient that is not zero
void BlockHold::follow(HoldingFriction& found, double minimum) {
  const auto& [lower, upper] = found.bracket;
  for (int round = 0; round < max_halvings && upper->value > minimum; ++round) {
    const auto standard = upper->proved() ? Standard::proved : Standard::computed;
    HoldNodes nodes(block_, std::array{LoadShare{1, 0}}, upper->value, parameters_.precision);
    const double start = std::max(found.bracket.at_least(), minimum);
    const auto result_at = [&](double mu) {
      nodes.set_friction(mu);
      return by_standard(nodes.solve(*found.pattern), standard);
    };
    if (start == minimum && result_at(minimum) == HoldResult::feasible) {
      found.bracket.upper->value = minimum;
      return;
    }
    Ends ends{upper->value, start};
    if (expected_) ends = approach(ends, *expected_, 0, result_at);
    ends = bisect(ends, 0, result_at);
    found.bracket.upper->value = ends.feasible;
    if (ends.infeasible <= found.bracket.at_least() || prove_lower(found, ends.infeasible)) return;
  }
}

}  // namespace kusabi::wedged
