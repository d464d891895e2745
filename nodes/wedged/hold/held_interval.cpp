// Interval of load factors of one sign pattern: every point of a bisection is a cone program.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "nodes/wedged/hold/block_hold.hpp"

namespace kusabi::wedged {
namespace {

/// Doublings of a load factor before its range counts as unbounded.
constexpr int max_doublings = 60;

}  // namespace

HoldResult BlockHold::at(const LoadedPattern& pattern, LoadShare share, double mu,
                         Standard standard) const {
  HoldNodes nodes(block_, std::array{share}, mu, parameters_.precision, grip_);
  return by_standard(nodes.solve(pattern), standard);
}

HoldResult BlockHold::by_standard(HoldResult result, Standard standard) {
  if (standard == Standard::proved) return result;
  if (result == HoldResult::at_limit || result == HoldResult::face) return HoldResult::feasible;
  return result == HoldResult::unloaded ? HoldResult::infeasible : result;
}

std::optional<HeldState> BlockHold::state(const std::optional<LoadedPattern>& pattern,
                                          double factor, double mu) const {
  if (!pattern || !std::isfinite(factor)) return {};
  HoldNodes nodes(block_, std::array{LoadShare{1, factor}}, mu, parameters_.precision, grip_);
  const HoldResult result = nodes.solve(*pattern);
  if (result != HoldResult::feasible && result != HoldResult::at_limit) return {};
  auto leaf = nodes.leaf(*pattern);
  const double amount = leaf.amounts.front();
  if (!(amount > 0)) return {};
  for (double& force : leaf.reaction) force /= amount;
  return HeldState{factor, std::move(leaf.reaction)};
}

// Ratio of both loads in terms of the displacements under them.
double BlockHold::factor_scale() const {
  if (grip_) return grip_->total / scale_of(block_, {0, 1});
  const double scale = scale_of(block_, {1, 0}) / scale_of(block_, {0, 1});
  return scale > 0 && std::isfinite(scale) ? scale : 1;
}

// Narrows a bracket beside an end that is known in advance to most digits: points on either side of
// it, ever farther away, until the first that is feasible and the first that is not.
BlockHold::Ends BlockHold::approach(Ends ends, double expected, double floor,
                                    const std::function<HoldResult(double)>& result_at) const {
  constexpr double growth = 64;
  const double least = std::max(parameters_.width * std::abs(expected), floor) / 4;
  const double outward = ends.infeasible > ends.feasible ? 1 : -1;
  for (const double side : {-outward, outward}) {
    const HoldResult wanted = side == outward ? HoldResult::infeasible : HoldResult::feasible;
    for (double distance = least; !ended(); distance *= growth) {
      const double point = expected + side * distance;
      const bool inside =
          (point - ends.feasible) * outward > 0 && (ends.infeasible - point) * outward > 0;
      if (!inside || !std::isfinite(point)) break;
      const HoldResult result = result_at(point);
      if (result == HoldResult::feasible) ends.feasible = point;
      if (result == HoldResult::infeasible) ends.infeasible = point;
      const bool decided = result == HoldResult::feasible || result == HoldResult::infeasible;
      if (!decided || result == wanted) break;
    }
  }
  return ends;
}

// Bisection. Undecided points divide the interval; both sides then approach them separately. Secants
// of t*, and the points up to which multipliers exclude states, took as many programs: these have many
// pieces near the end, and a program that is solved beyond its sign takes twice the iterations.
BlockHold::Ends BlockHold::bisect(Ends ends, double floor,
                                  const std::function<HoldResult(double)>& result_at) const {
  auto [feasible, infeasible, unbounded_by_limit, wide] = ends;
  double open_feasible = infeasible, open_infeasible = feasible;  // nearest undecided points
  const auto narrow = [&](double from, double to) {
    return std::abs(to - from) <=
           std::max(parameters_.width * std::max(std::abs(from), std::abs(to)), floor);
  };
  bool met_open = false;
  bool stopped = false;
  for (int step = 0; step < max_halvings && !stopped; ++step, stopped = ended()) {
    const bool toward_infeasible = met_open && step % 2 != 0;
    const double from = !met_open ? feasible : toward_infeasible ? open_infeasible : feasible;
    const double to = !met_open ? infeasible : toward_infeasible ? infeasible : open_feasible;
    if (narrow(feasible, infeasible) ||
        (met_open && narrow(feasible, open_feasible) && narrow(open_infeasible, infeasible)))
      break;
    const double middle = from + (to - from) / 2;
    if (middle == from || middle == to) {
      if (!met_open) break;
      continue;
    }
    switch (result_at(middle)) {
      case HoldResult::feasible:
        feasible = middle;
        break;
      case HoldResult::infeasible:
        infeasible = middle;
        break;
      default:
        if (!met_open) open_feasible = open_infeasible = middle;
        (toward_infeasible ? open_infeasible : open_feasible) = middle;
        met_open = true;
    }
  }
  wide = (met_open || stopped) &&
         std::abs(infeasible - feasible) >
             std::max(close_enough * std::max(std::abs(feasible), std::abs(infeasible)), floor);
  return {feasible, infeasible, unbounded_by_limit, wide};
}

BlockHold::Ends BlockHold::extend(const LoadedPattern& pattern, double from, int direction,
                                  double mu, Standard standard) const {
  const double end = direction * unbounded_end;
  // Any multiple of a state of the reference load alone may be added to a state.
  const LoadShare reference{0, static_cast<double>(direction)};
  if (at(pattern, reference, mu, Standard::proved) == HoldResult::feasible) return {end, end};
  if (at(pattern, reference, mu, Standard::computed) == HoldResult::feasible)
    return {end, end, true};
  const double scale = factor_scale();
  const double floor = min_factor_share * scale;
  const auto result_at = [&](double factor) { return at(pattern, {1, factor}, mu, standard); };
  Ends ends{from, end};
  const double expected = !statics_ ? end : direction > 0 ? statics_->high : statics_->low;
  if (std::isfinite(expected)) ends = approach(ends, expected, floor, result_at);
  double step = std::max(std::abs(from), scale);
  for (int doubling = 0; doubling < max_doublings && std::isinf(ends.infeasible) && !ended();
       ++doubling, step *= 2) {
    const double next = from + direction * step;
    if ((next - ends.feasible) * direction <= 0) continue;
    const HoldResult result = result_at(next);
    if (result == HoldResult::feasible) ends.feasible = next;
    if (result == HoldResult::infeasible) ends.infeasible = next;
  }
  if (std::isinf(ends.infeasible)) return ends;
  ends = bisect(ends, floor, result_at);
  if (std::min(ends.feasible, ends.infeasible) < 0 &&
      std::max(ends.feasible, ends.infeasible) > 0) {
    const HoldResult result = result_at(0);
    if (result == HoldResult::feasible) ends.feasible = 0;
    if (result == HoldResult::infeasible) ends.infeasible = 0;
  }
  return ends;
}

HeldInterval BlockHold::interval(const LoadedPattern& pattern, double from, double mu,
                                 Standard standard) const {
  const Ends up = extend(pattern, from, 1, mu, standard);
  const Ends down = extend(pattern, from, -1, mu, standard);
  const auto states = support::proved_if(
      standard == Standard::proved && !up.unbounded_by_limit && !down.unbounded_by_limit &&
      at(pattern, {1, from}, mu, standard) == HoldResult::feasible);
  const auto outside = [](const Ends& ends) {
    return support::proved_if(std::isinf(ends.feasible) ||
                              (std::isfinite(ends.infeasible) && !ends.wide));
  };
  HeldInterval held{{down.infeasible, outside(down)},
                    down.feasible,
                    up.feasible,
                    {up.infeasible, outside(up)},
                    states};
  held.pattern = pattern;
  return held;
}

}  // namespace kusabi::wedged
