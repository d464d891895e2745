// Search of ranges of load factors until each is held or infeasible.
#include "nodes/wedged/hold/block_hold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include <Eigen/QR>

#include "nodes/wedged/hold/bounded_search.hpp"

namespace kusabi::wedged {
namespace {

using support::Standing;

/// Maximum number of ranges of one block that are searched.
constexpr int max_ranges = 128;

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

// The factors of a pattern between two intervals of its own: its states are convex.
HeldInterval hull_of(const HeldInterval& one, const HeldInterval& other) {
  const bool higher = one.high > other.high ||
                      (one.high == other.high && one.high_out.value <= other.high_out.value);
  HeldInterval hull = higher ? one : other;
  const auto& lower = one.low <= other.low ? one : other;
  hull.low = lower.low;
  hull.low_out = lower.low_out;
  hull.standing = both(one.standing, other.standing);
  return hull;
}

}  // namespace

HoldOutcome BlockHold::search(std::span<const LoadShare> shares, double mu, double low, double high,
                              bool except_zero) {
  TreeEvidence evidence{mu, {shares.begin(), shares.end()}, grip_};
  evidence.except_dead = except_zero;
  auto found = search_for_state(analysis_, block_, evidence, parameters_, recorded_);
  costs_.push_back({mu, low, high, found.opened, found.tally.iterations});
  if (recorded_ && !shares.empty() && found.is_infeasible()) {
    std::erase_if(trees_, [&](const TreeEvidence& each) { return each.mu != mu; });
    trees_.push_back(std::move(evidence));
  }
  return found;
}

bool BlockHold::holds_zero(double mu) {
  if (std::exchange(zero_searched_, true)) return zero_.has_value();
  const auto outcome = search(std::array{LoadShare{1, 0}}, mu, 0, 0);
  if (outcome.status == engine::Status::solved) zero_ = state_of_dead(outcome, 0, 0);
  return zero_.has_value();
}

// The interval of the factors that a tree of the dead load alone decides; nothing if it has no state.
std::optional<HeldInterval> BlockHold::state_of_dead(const HoldOutcome& outcome, double low,
                                                     double high) {
  const bool proved = !outcome.leaves.empty();
  if (!proved && outcome.tally.limits.empty()) return {};
  auto held = HeldInterval::from(low, high, Standing::proved);
  held.standing = support::proved_if(proved);
  held.pattern = (proved ? outcome.leaves : outcome.tally.limits).front().pattern;
  if (proved) pieces_.push_back({*held.pattern, 0, 0, 0});
  return held;
}

// A bracket about 0 that is narrow in comparison with both loads: an end there may be 0.
bool BlockHold::may_end_at_zero(double held, double out) const {
  return held != 0 && held * out <= 0 && std::abs(held) <= parameters_.width * factor_scale();
}

// True if the state at 0 is one of this pattern, too, once a rigid-body motion closes the gaps of
// the candidates that only the pattern has in contact (docs/theory/proofs.md, "Conclusions").
bool BlockHold::touches_with(const LoadedPattern& pattern) const {
  const support::IndexSet& own = zero_->pattern->contact;
  if (!pattern.separated.empty() || !pattern.contact.includes(own)) return false;
  const auto rank = [&](const support::IndexSet& candidates) {
    std::vector<Eigen::Index> normals;
    for (const int i : candidates) normals.push_back(Eigen::Index{block_.problem.dimension} * i);
    const Eigen::MatrixXd rows = block_.problem.modes.matrix(normals, Eigen::all);
    return rows.rows() == 0 ? 0 : rows.colPivHouseholderQr().rank();
  };
  return rank(pattern.contact) - rank(own) == (pattern.contact - own).size();
}

// An interval that ends near 0, where there is a state, ends there: at 0 itself if that state is one
// of its pattern.
void BlockHold::join_zero(HeldFactors& found) const {
  if (!zero_) return;
  bool joined = false;
  const auto join = [&](const HeldInterval& each, double& held, support::Bound& out, double away) {
    joined = true;
    const bool same = zero_->standing == Standing::proved && touches_with(*each.pattern);
    if (same) held = 0;
    out = support::Bound{same ? 0 : std::nextafter(0, away), Standing::proved};
  };
  for (auto& each : found.intervals) {
    if (each.low > 0 && may_end_at_zero(each.low, each.low_out.value))
      join(each, each.low, each.low_out, -unbounded_end);
    if (each.high < 0 && may_end_at_zero(each.high, each.high_out.value))
      join(each, each.high, each.high_out, unbounded_end);
    joined = joined || (each.low <= 0 && each.high >= 0);
  }
  if (!joined) found.intervals.push_back(*zero_);
}

bool BlockHold::wedges(double mu) {
  const auto outcome = search({}, mu, 0, 0);
  if (outcome.leaves.empty() ||
      !resists_all(block_.problem, outcome.leaves.front().pattern.contact, mu))
    return false;
  wedged_ = outcome.leaves.front().pattern;
  return true;
}

// Without a dead part, states can be multiplied: the factors are 0, and all of one sign or none.
HeldFactors BlockHold::homogeneous_factors(double mu) {
  HeldFactors found{.outside = Standing::proved};
  auto all = HeldInterval::from(0, 0, Standing::proved);
  for (const int direction : {-1, 1}) {
    const LoadShare share{0, static_cast<double>(direction)};
    const auto outcome = search(std::array{share}, mu, direction < 0 ? -unbounded_end : 0,
                                direction < 0 ? 0 : unbounded_end);
    for (const auto& leaf : outcome.leaves)
      pieces_.push_back(
          {leaf.pattern, direction < 0 ? -unbounded_end : 0, direction < 0 ? 0 : unbounded_end, 0});
    if (outcome.status != engine::Status::solved) found.status = outcome.status;
    const bool at_limit = outcome.leaves.empty() && !outcome.tally.limits.empty();
    const bool held = !outcome.leaves.empty() || at_limit;
    if (at_limit) all.standing = Standing::computed;
    if (!held && !outcome.is_infeasible()) found.outside = Standing::computed;
    if (!held && outcome.is_unresolved()) found.unresolved = true;
    auto& out = direction < 0 ? all.low_out : all.high_out;
    out.standing = support::proved_if(held || outcome.is_infeasible());
    if (!held) continue;
    out.value = (direction < 0 ? all.low : all.high) = direction * unbounded_end;
    all.pattern = (at_limit ? outcome.tally.limits.front() : outcome.leaves.front()).pattern;
  }
  found.intervals.push_back(all);
  return found;
}

// Adds the interval of a leaf, with all between it and others of its pattern, and removes it from the
// unknown ranges, up to the factors that the pattern does not hold. An end without one leaves the
// rest unknown.
void BlockHold::take(const LoadedLeaf& leaf, double low, double high, Standard standard,
                     HeldFactors& found, std::vector<FactorRange>& unknown, double mu) {
  const double from = factor_in(leaf, range_of(low, high));
  HeldInterval held = interval(leaf.pattern, from, mu, standard);
  const double own_low = held.low, own_high = held.high;
  std::erase_if(found.intervals, [&](const HeldInterval& each) {
    const bool same = each.pattern == held.pattern && each.standing == held.standing;
    if (same) held = hull_of(held, each);
    return same;
  });
  // The range beyond an end near 0 is searched by itself.
  const auto is_open = [&](const support::Bound& out, double own) {
    return !out.proved() && !(may_end_at_zero(own, out.value) && holds_zero(mu));
  };
  found.unresolved =
      found.unresolved || is_open(held.high_out, held.high) || is_open(held.low_out, held.low);
  const auto end = [&](double out, double own) {
    if (may_end_at_zero(own, out) && holds_zero(mu)) return 0.0;
    return std::isfinite(out) ? out : own;
  };
  const double below = end(held.low_out.value, held.low);
  const double above = end(held.high_out.value, held.high);
  std::vector<FactorRange> left;
  for (const FactorRange& each : unknown) {
    if (each.low < below) left.push_back({each.low, std::min(each.high, below), true});
    if (each.high > above) left.push_back({std::max(each.low, above), each.high, true});
  }
  unknown = std::move(left);
  found.intervals.push_back(held);
  if (standard == Standard::proved) pieces_.push_back({leaf.pattern, own_low, own_high, from});
}

// Degenerate states of a range: the rest of it beside the first of them that has an interval is
// searched again. False if there is none.
bool BlockHold::take_limits(std::span<const LoadedLeaf> limits, double low, double high,
                            HeldFactors& found, std::vector<FactorRange>& unknown, double mu) {
  const auto shares = range_of(low, high);
  for (const auto& leaf : limits) {
    const double factor = factor_in(leaf, shares);
    if (zero_ && std::abs(factor) <= min_factor_share * factor_scale()) continue;
    if (std::isfinite(factor)) {
      take(leaf, low, high, Standard::computed, found, unknown, mu);
      if (unknown.empty() || !(unknown.back() == FactorRange{low, high, true})) return true;
    }
    found.unresolved = true;
  }
  return false;
}

void BlockHold::explore(HeldFactors& found, std::vector<FactorRange>& empty_ranges, double mu) {
  std::vector<FactorRange> unknown{{-unbounded_end, 0, true}, {0, unbounded_end, true}};
  for (int range = 0; !unknown.empty(); ++range) {
    const auto [low, high, proved] = unknown.back();
    const auto shares = range_of(low, high);
    auto outcome = search(shares, mu, low, high);
    // A state of the dead load alone, with equalities, is no state of the range beside it.
    const bool decided = outcome.status != engine::Status::solved || !outcome.leaves.empty() ||
                         outcome.is_infeasible();
    const bool beside_zero = low == 0 || high == 0;
    const bool except_zero = !decided && beside_zero && holds_zero(mu);
    if (except_zero) outcome = search(shares, mu, low, high, true);
    if (outcome.status != engine::Status::solved) found.status = outcome.status;
    if (found.status != engine::Status::solved || range >= max_ranges) {
      found.unresolved = true;
      for (const FactorRange& each : unknown) empty_ranges.push_back({each.low, each.high, false});
      return;
    }
    if (!outcome.leaves.empty()) {
      take(outcome.leaves.front(), low, high, Standard::proved, found, unknown, mu);
      if (unknown.empty() || !(unknown.back() == FactorRange{low, high, true})) continue;
      found.unresolved = true;
    } else if (take_limits(outcome.tally.limits, low, high, found, unknown, mu)) {
      continue;
    }
    unknown.pop_back();
    const bool open = except_zero && outcome.is_infeasible();
    empty_ranges.push_back({open && low == 0 ? std::nextafter(0, unbounded_end) : low,
                            open && high == 0 ? std::nextafter(0, -unbounded_end) : high,
                            outcome.is_infeasible()});
    if (outcome.tally.unresolved() != 0) found.unresolved = true;
  }
}

namespace {

// Adds an interval that begins in the last one, or at an end that is not distinguished from its
// own. Each end keeps the factor that is not held beyond it, and what is proved of that.
void extend_by(HeldInterval& last, const HeldInterval& each) {
  if (each.low_out.value < last.low_out.value) last.low_out = each.low_out;
  if (each.high_out.value > last.high_out.value) last.high_out = each.high_out;
  const bool inside = each.low >= last.low && each.high <= last.high;
  if (inside) return;  // also if it is only computed
  const bool overlap = each.low <= last.high;
  last.standing = overlap ? both(last.standing, each.standing) : Standing::computed;
  if (each.high > last.high) last.pattern = each.pattern;
  last.high = std::max(last.high, each.high);
}

// The union of all. Between intervals whose brackets overlap, but are wide, no factor is known that
// is not held.
std::vector<HeldInterval> joined(std::vector<HeldInterval> all) {
  std::ranges::sort(all, {}, &HeldInterval::low);
  std::vector<HeldInterval> result;
  for (auto& each : all) {
    const bool apart = result.empty() || each.low > result.back().high;
    const bool close = !result.empty() && each.low_out.value <= result.back().high_out.value;
    if (apart && close && !(each.low_out.proved() && result.back().high_out.proved())) {
      result.back().high_out = support::Bound{unbounded_end};
      each.low_out = support::Bound{-unbounded_end};
    } else if (!apart || close) {
      extend_by(result.back(), each);
      continue;
    }
    result.push_back(each);
  }
  return result;
}

}  // namespace

HeldFactors BlockHold::factors(double mu, bool with_dead) {
  HeldFactors found{.outside = Standing::proved};
  if (!grip_ && wedges(mu)) {
    found.any_by_wedging = true;
    found.intervals.push_back(HeldInterval::from(-unbounded_end, unbounded_end, Standing::proved));
    return found;
  }
  if (!with_dead && !grip_) return homogeneous_factors(mu);
  statics_ = by_first_rank(
      [&](const support::Stop& stop) { return static_range(block_, mu, parameters_.total, stop); });
  std::vector<FactorRange> empty_ranges;
  zero_searched_ = false;
  zero_.reset();
  explore(found, empty_ranges, mu);
  join_zero(found);
  if (ended_ && found.status == engine::Status::solved) found.status = analysis_.stop_reason();
  for (const FactorRange& gap : empty_ranges) {
    if (!gap.proved) continue;
    for (auto& each : found.intervals) {
      if (gap.high <= each.low && !std::isfinite(each.low_out.value)) each.low_out.value = gap.high;
      if (gap.low >= each.high && !std::isfinite(each.high_out.value))
        each.high_out.value = gap.low;
    }
  }
  found.intervals = joined(std::move(found.intervals));
  for (const FactorRange& gap : empty_ranges) {
    if (gap.proved) continue;
    found.outside = Standing::computed;
    for (auto& each : found.intervals) {
      auto [low_out, high_out] = std::tie(each.low_out, each.high_out);
      if (gap.low <= high_out.value && gap.high > high_out.value)
        high_out.standing = Standing::computed;
      if (gap.high >= low_out.value && gap.low < low_out.value)
        low_out.standing = Standing::computed;
    }
  }
  for (auto& each : found.intervals) {
    found.outside = both(found.outside, both(each.low_out.standing, each.high_out.standing));
    each.state = state(each.pattern, each.high, mu);
    if (!each.state) each.state = state(each.pattern, each.low, mu);
  }
  return found;
}

HeldFactors BlockHold::dead_alone(double mu) {
  HeldFactors found{.outside = Standing::proved};
  const auto outcome = search(std::array{LoadShare{1, 0}}, mu, 0, 0);
  found.status = outcome.status;
  auto all = state_of_dead(outcome, -unbounded_end, unbounded_end);
  if (!all) {
    found.outside = support::proved_if(outcome.is_infeasible());
    found.unresolved = outcome.is_unresolved();
    return found;
  }
  all->state = state(all->pattern, 0, mu);
  found.intervals.push_back(*all);
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

}  // namespace kusabi::wedged
