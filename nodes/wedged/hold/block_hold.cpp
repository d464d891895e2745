// Search of ranges of load factors until each is held or infeasible, and bisection of friction.
#include "nodes/wedged/hold/block_hold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace kusabi::wedged {
namespace {

/// Doublings of a load factor before its range counts as unbounded.
constexpr int max_doublings = 60;

/// Bisections of one end: more than the digits of a double.
constexpr int max_halvings = 70;

/// Maximum number of intervals of one block.
constexpr int max_intervals = 64;

/// Load factors below this share of the ratio of both loads are zero to all digits of either.
constexpr double min_factor_share = 1e-12;

/// Relative steps below a leaf's own coefficient at which the tree is searched if it is degenerate
/// there.
constexpr std::array<double, 4> steps_below{0, 1e-8, 1e-6, 1e-4};

/// A bracket of the coefficient that is not divided by trees, and of a load factor that counts as
/// decided, relative: a hundred times that of a leaf.
constexpr double close_enough = 1e-7;

/// The least friction factor that is not zero; infinite if there is none.
double min_of_factors(const problems::WedgedProblem& problem) {
  double minimum = unbounded_end;
  for (const double factor : problem.friction)
    if (factor > 0) minimum = std::min(minimum, factor);
  return minimum;
}

std::vector<LoadShare> range_of(double low, double high) {
  std::vector<LoadShare> shares;
  if (std::isinf(low)) shares.push_back({0, -1});
  if (std::isfinite(low)) shares.push_back({1, low});
  if (std::isinf(high)) shares.push_back({0, 1});
  if (std::isfinite(high) && high > low) shares.push_back({1, high});
  return shares;
}

/// lambda of a state of a range of factors.
double factor_in(const LoadedLeaf& leaf, std::span<const LoadShare> shares) {
  double dead = 0;
  double reference = 0;
  for (std::size_t j = 0; j < shares.size(); ++j) {
    dead += leaf.amounts[j] * shares[j].dead;
    reference += leaf.amounts[j] * shares[j].reference;
  }
  return reference / dead;
}

}  // namespace

HoldOutcome BlockHold::search(std::span<const LoadShare> shares, double mu, double low,
                              double high) {
  HoldTree tree(block_, shares, mu, parameters_.precision, grip_);
  TreeEvidence evidence{mu, {shares.begin(), shares.end()}, grip_};
  auto found = first_leaf(analysis_, tree, recorded_ ? &evidence : nullptr);
  costs_.push_back({mu, low, high, found.opened, found.tally.iterations});
  if (recorded_ && !shares.empty() && found.is_infeasible()) {
    std::erase_if(trees_, [&](const TreeEvidence& each) { return each.mu != mu; });
    trees_.push_back(std::move(evidence));
  }
  return found;
}

HoldResult BlockHold::at(const LoadedPattern& pattern, LoadShare share, double mu,
                         Standard standard) const {
  HoldNodes nodes(block_, std::array{share}, mu, parameters_.precision, grip_);
  const HoldResult result = nodes.solve(pattern);
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

// Bisection. Undecided points divide the interval; both sides then approach them separately.
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
  double feasible = from;
  double step = std::max(std::abs(from), scale);
  double infeasible = end;
  for (int doubling = 0; doubling < max_doublings && !ended(); ++doubling, step *= 2) {
    const double next = from + direction * step;
    const HoldResult result = at(pattern, {1, next}, mu, standard);
    if (result == HoldResult::feasible) feasible = next;
    if (result != HoldResult::infeasible) continue;
    infeasible = next;
    break;
  }
  if (std::isinf(infeasible)) return {feasible, infeasible};
  return bisect({feasible, infeasible}, min_factor_share * scale, [&](double factor) {
    return at(pattern, {1, factor}, mu, standard);
  });
}

bool BlockHold::wedges(double mu) {
  const auto outcome = search({}, mu, 0, 0);
  if (outcome.leaf.empty() ||
      !resists_all(block_.problem, outcome.leaf.front().pattern.contact, mu))
    return false;
  wedged_ = outcome.leaf.front().pattern;
  return true;
}

// Without a dead part, states can be multiplied: the factors are 0, and all of one sign or none.
HeldFactors BlockHold::homogeneous_factors(double mu) {
  HeldFactors found;
  HeldInterval all{0, 0, 0, 0};
  for (const int direction : {-1, 1}) {
    const LoadShare share{0, static_cast<double>(direction)};
    const auto outcome = search(std::array{share}, mu, direction < 0 ? -unbounded_end : 0,
                                direction < 0 ? 0 : unbounded_end);
    for (const auto& leaf : outcome.leaf)
      pieces_.push_back(
          {leaf.pattern, direction < 0 ? -unbounded_end : 0, direction < 0 ? 0 : unbounded_end, 0});
    if (outcome.status != engine::Status::solved) found.status = outcome.status;
    const bool at_limit = outcome.leaf.empty() && !outcome.tally.limits.empty();
    const bool held = !outcome.leaf.empty() || at_limit;
    if (at_limit) all.proved = false;
    if (!held && !outcome.is_infeasible()) found.proved = false;
    if (!held && outcome.is_unresolved()) found.unresolved = true;
    (direction < 0 ? all.low_proved : all.high_proved) = held || outcome.is_infeasible();
    if (!held) continue;
    (direction < 0 ? all.low : all.high) = direction * unbounded_end;
    (direction < 0 ? all.low_out : all.high_out) = direction * unbounded_end;
    all.pattern = (at_limit ? outcome.tally.limits.front() : outcome.leaf.front()).pattern;
  }
  found.intervals.push_back(all);
  return found;
}

HeldInterval BlockHold::interval(const LoadedPattern& pattern, double from, double mu,
                                 Standard standard) const {
  const Ends up = extend(pattern, from, 1, mu, standard);
  const Ends down = extend(pattern, from, -1, mu, standard);
  HeldInterval held{down.infeasible, down.feasible, up.feasible, up.infeasible};
  held.pattern = pattern;
  held.proved = standard == Standard::proved && !up.unbounded_by_limit &&
                !down.unbounded_by_limit &&
                at(pattern, {1, from}, mu, standard) == HoldResult::feasible;
  held.high_proved = std::isinf(up.feasible) || (std::isfinite(up.infeasible) && !up.wide);
  held.low_proved = std::isinf(down.feasible) || (std::isfinite(down.infeasible) && !down.wide);
  return held;
}

// Adds the interval of a leaf, and removes it from the unknown ranges.
void BlockHold::take(const LoadedLeaf& leaf, double low, double high, Standard standard,
                     HeldFactors& found, std::vector<Gap>& unknown, double mu) {
  const double from = factor_in(leaf, range_of(low, high));
  const HeldInterval held = interval(leaf.pattern, from, mu, standard);
  found.unresolved = found.unresolved || !held.high_proved || !held.low_proved;
  std::vector<Gap> left;
  for (const Gap& each : unknown) {
    if (each.low < held.low_out)
      left.push_back({each.low, std::min(each.high, held.low_out), true});
    if (each.high > held.high_out)
      left.push_back({std::max(each.low, held.high_out), each.high, true});
  }
  unknown = std::move(left);
  found.intervals.push_back(held);
  if (standard == Standard::proved) pieces_.push_back({leaf.pattern, held.low, held.high, from});
}

// Degenerate states of a range: the rest of it beside the first of them that has an interval is
// searched again. False if there is none.
bool BlockHold::take_limits(std::span<const LoadedLeaf> limits, double low, double high,
                            HeldFactors& found, std::vector<Gap>& unknown, double mu) {
  const auto shares = range_of(low, high);
  for (const auto& leaf : limits) {
    if (!std::isfinite(factor_in(leaf, shares))) continue;
    take(leaf, low, high, Standard::computed, found, unknown, mu);
    if (unknown.empty() || unknown.back().low != low || unknown.back().high != high) return true;
    found.unresolved = true;
  }
  return false;
}

void BlockHold::explore(HeldFactors& found, std::vector<Gap>& gaps, double mu) {
  std::vector<Gap> unknown{{-unbounded_end, 0, true}, {0, unbounded_end, true}};
  while (!unknown.empty()) {
    const auto [low, high, proved] = unknown.back();
    const auto shares = range_of(low, high);
    const auto outcome = search(shares, mu, low, high);
    if (outcome.status != engine::Status::solved) found.status = outcome.status;
    if (found.status != engine::Status::solved ||
        static_cast<int>(found.intervals.size()) >= max_intervals) {
      found.unresolved = true;
      for (const Gap& each : unknown) gaps.push_back({each.low, each.high, false});
      return;
    }
    if (!outcome.leaf.empty()) {
      take(outcome.leaf.front(), low, high, Standard::proved, found, unknown, mu);
      continue;
    }
    if (take_limits(outcome.tally.limits, low, high, found, unknown, mu)) continue;
    unknown.pop_back();
    gaps.push_back({low, high, outcome.is_infeasible()});
    if (outcome.tally.unresolved() != 0) found.unresolved = true;
  }
}

namespace {

// Intervals that overlap, or whose ends are not distinguished, become one.
std::vector<HeldInterval> joined(std::vector<HeldInterval> all) {
  std::ranges::sort(all, {}, &HeldInterval::low);
  std::vector<HeldInterval> result;
  for (const auto& each : all) {
    if (result.empty() || each.low_out > result.back().high_out) {
      result.push_back(each);
      continue;
    }
    auto& last = result.back();
    const bool inside = each.low >= last.low && each.high <= last.high;
    if (inside) continue;  // also an end that is only computed
    last.proved = last.proved && each.proved && each.low <= last.high;
    last.low_out = std::min(last.low_out, each.low_out);
    if (each.high > last.high) last.pattern = each.pattern;
    last.high = std::max(last.high, each.high);
    last.high_out = std::max(last.high_out, each.high_out);
  }
  return result;
}

}  // namespace

HeldFactors BlockHold::factors(double mu, bool with_dead) {
  HeldFactors found;
  if (!grip_ && wedges(mu)) {
    found.any_by_wedging = true;
    found.intervals.push_back({-unbounded_end, -unbounded_end, unbounded_end, unbounded_end});
    return found;
  }
  if (!with_dead && !grip_) return homogeneous_factors(mu);
  std::vector<Gap> gaps;
  explore(found, gaps, mu);
  if (ended_ && found.status == engine::Status::solved) found.status = analysis_.stop_reason();
  found.intervals = joined(std::move(found.intervals));
  for (const Gap& gap : gaps) {
    found.proved = found.proved && gap.proved;
    for (auto& each : found.intervals) {
      if (gap.proved) continue;
      if (gap.low <= each.high_out && gap.high > each.high_out) each.high_proved = false;
      if (gap.high >= each.low_out && gap.low < each.low_out) each.low_proved = false;
    }
  }
  for (auto& each : found.intervals) {
    each.state = state(each.pattern, each.high, mu);
    if (!each.state) each.state = state(each.pattern, each.low, mu);
  }
  return found;
}

HeldFactors BlockHold::dead_alone(double mu) {
  HeldFactors found;
  const auto outcome = search(std::array{LoadShare{1, 0}}, mu, 0, 0);
  found.status = outcome.status;
  const bool at_limit = outcome.leaf.empty() && !outcome.tally.limits.empty();
  if (outcome.leaf.empty() && !at_limit) {
    found.proved = outcome.is_infeasible();
    found.unresolved = outcome.is_unresolved();
    return found;
  }
  if (!at_limit) pieces_.push_back({outcome.leaf.front().pattern, 0, 0, 0});
  HeldInterval all{-unbounded_end, -unbounded_end, unbounded_end, unbounded_end};
  all.proved = !at_limit;
  all.pattern = (at_limit ? outcome.tally.limits.front() : outcome.leaf.front()).pattern;
  all.state = state(all.pattern, 0, mu);
  found.intervals.push_back(all);
  return found;
}

void BlockHold::record(const RecordedBlock& block, HoldRecord& record) const {
  const bool has_dead = grip_ || block_.has_dead_part();
  if (wedged_) record_state(analysis_, block, *wedged_, {}, {}, record);
  for (const auto& piece : pieces_) {
    const auto add = [&](LoadShare share) {
      record_state(analysis_, block, piece.pattern, share, grip_, record);
    };
    if (has_dead) {
      for (const double factor : std::set{piece.low, piece.inside, piece.high})
        if (std::isfinite(factor)) add({1, factor});
    }
    if (std::isinf(piece.low)) add({0, -1});
    if (std::isinf(piece.high)) add({0, 1});
  }
  for (const auto& tree : trees_) record_tree(analysis_, block, tree, record);
}

// A proved lower bound at or below a coefficient at which the leaf itself is infeasible. False if
// another leaf has a state there, which is then the upper bound of the answer.
bool BlockHold::prove_lower(HoldingFriction& found, double most_infeasible) {
  const std::array share{LoadShare{1, 0}};
  for (const double step : steps_below) {
    const double mu = most_infeasible * (1 - step);
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
