// Holding friction coefficient of a block: trees at coefficients from 0 on, and the coefficient of
// a leaf by bisection.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

// Searches at one coefficient for a state under the dead load, and moves an end of the bracket
// there: the upper one with a state, which is computed if only leaves at a limit have one. Leaves
// of unknown sign leave both ends.
BlockHold::Answer BlockHold::move_end(HoldingFriction& found, double mu) {
  const auto outcome = search(std::array{LoadShare{1, 0}}, mu, 0, 0);
  found.status = outcome.status;
  if (found.status != engine::Status::solved) return Answer::unknown;
  const auto& limits = outcome.tally.limits;
  const bool held = !outcome.leaf.empty();
  if (held || !limits.empty()) {
    found.upper = mu;
    found.upper_proved = held;
    found.pattern = (held ? outcome.leaf.front() : limits.front()).pattern;
    return held ? Answer::held : Answer::at_limit;
  }
  if (outcome.is_unresolved()) return Answer::unknown;
  found.lower = mu;
  found.lower_known = true;
  found.lower_proved = outcome.is_infeasible();
  return found.lower_proved ? Answer::excluded : Answer::unknown;
}

// A proved lower bound at or below a coefficient at which the leaf itself is infeasible. False if
// another leaf has a state there, or at the last step one at a limit, which is then the upper bound
// of the answer.
bool BlockHold::prove_lower(HoldingFriction& found, double max_infeasible) {
  HoldingFriction next;
  Answer answer = Answer::unknown;
  for (const double step : steps_below) {
    next = found;
    answer = move_end(next, max_infeasible * (1 - step));
    if (next.status != engine::Status::solved || answer == Answer::held ||
        answer == Answer::excluded)
      break;
  }
  found = std::move(next);
  return answer != Answer::held && answer != Answer::at_limit;
}

// Bisects a range of coefficients in which leaves are degenerate, with one tree at each point. The
// lower end is proved only if the last tree there is infeasible, otherwise computed.
void BlockHold::narrow(HoldingFriction& found) {
  double low = found.lower;  // also where nothing is known
  for (int step = 0; found.upper && step < max_halvings; ++step) {
    if (*found.upper - low <= close_enough * *found.upper) return;
    const double mu = low + (*found.upper - low) / 2;
    if (mu * min_of_factors(block_.problem) < min_friction) return;
    move_end(found, mu);
    if (found.status != engine::Status::solved) return;
    if (*found.upper != mu) low = mu;
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
  move_end(found, 0);
  for (double mu = std::min(1.0, found.maximum);
       !found.upper && mu > 0 && found.status == engine::Status::solved;
       mu = mu < found.maximum ? std::min(10 * mu, found.maximum) : 0)
    move_end(found, mu);
  return found.status == engine::Status::solved && found.upper.value_or(0) > 0;
}

// Follows the leaf of the upper bound to its own coefficient, until the tree below it is infeasible
// or has degenerate leaves only.
// @param minimum coefficient that is not zero
void BlockHold::follow(HoldingFriction& found, double minimum) {
  while (*found.upper > minimum) {
    HoldNodes nodes(block_, std::array{LoadShare{1, 0}}, *found.upper, parameters_.precision);
    const double start = std::max(found.lower, minimum);
    const auto standard = found.upper_proved ? Standard::proved : Standard::computed;
    const auto result_at = [&](double mu) {
      nodes.set_friction(mu);
      return by_standard(nodes.solve(*found.pattern), standard);
    };
    if (start == minimum && result_at(minimum) == HoldResult::feasible) {
      found.upper = minimum;
      return;
    }
    const double before = *found.upper;
    const Ends ends = bisect({before, start}, 0, result_at);
    found.upper = ends.feasible;
    const bool stays = standard == Standard::computed && ends.feasible == before;
    if (stays || ends.infeasible <= found.lower || prove_lower(found, ends.infeasible)) return;
  }
}

}  // namespace kusabi::wedged
