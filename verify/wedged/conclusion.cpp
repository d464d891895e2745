// Conclusions for each block, and for the whole structure. Ends of ranges are numbers of the
// certificate, so comparisons are exact; sums over blocks are rounded to the safe side.
#include "verify/wedged/conclusion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace kusabi::verify {
namespace {

constexpr double unbounded_end = std::numeric_limits<double>::infinity();

/// The end of a range of all factors that are not 0: there is no double between.
constexpr double beside_zero = std::numeric_limits<double>::denorm_min();

class Conclusions {
 public:
  Conclusions(const Certificate& certificate, const Proof& proof, const Proved& proved)
      : certificate_(certificate), proof_(proof), proved_(proved) {}

  [[nodiscard]] Conclusion of_patterns() const;
  [[nodiscard]] HoldClaims of_loads() const;

 private:
  [[nodiscard]] bool is_proved_empty(std::size_t theorem) const;
  [[nodiscard]] bool has_total(const State& state) const;
  [[nodiscard]] std::optional<FactorRange> excluded_by(const Theorem& theorem) const;
  [[nodiscard]] std::vector<FactorRange> held_by(std::size_t block) const;
  [[nodiscard]] GripRange grip_of(std::size_t block) const;
  [[nodiscard]] bool restricts_a_sum() const;
  [[nodiscard]] GripRange grip() const;

  // True if the dead load has a share in the states of a block: with a total, which is in units of
  // it, also where no load acts.
  [[nodiscard]] bool dead_matters(std::size_t block) const {
    return certificate_.total || proof_.actions()[block].dead;
  }

  const Certificate& certificate_;
  const Proof& proof_;
  const Proved& proved_;
};

Conclusion Conclusions::of_patterns() const {
  if (certificate_.theorems.empty()) {
    if (std::ranges::find(proved_.states, true) != proved_.states.end()) return {};
    return {.refusal = "it has neither theorems nor a wedged configuration that is proved"};
  }
  for (std::size_t block = 0; block < certificate_.blocks.size(); ++block) {
    if (std::ranges::find(certificate_.theorems, block, &Theorem::block) ==
        certificate_.theorems.end())
      return {.refusal = "no theorem is about block " + std::to_string(block + 1)};
  }
  return {.complete_list = std::ranges::find(proved_.theorems, false) == proved_.theorems.end()};
}

// True if no pattern is left out: neither a node without a claim nor a wedged configuration.
bool Conclusions::is_proved_empty(std::size_t number) const {
  const auto& theorem = certificate_.theorems[number];
  const auto left_out = [&](const Node& node) {
    return node.theorem == number && node.claim == Claim::none;
  };
  const auto wedged = [&](const State& state) {
    return theorem.about_wedged() && !state.share && state.block == theorem.block;
  };
  return proved_.theorems[number] && std::ranges::none_of(certificate_.nodes, left_out) &&
         std::ranges::none_of(certificate_.states, wedged);
}

// The load factors whose loads are in the cone of the shares.
std::optional<FactorRange> Conclusions::excluded_by(const Theorem& theorem) const {
  if (theorem.grip && theorem.grip->kind != GripBound::Kind::equal) return {};
  FactorRange range{unbounded_end, -unbounded_end};
  bool upward = false;
  bool downward = false;
  for (const auto& [dead, reference] : theorem.shares) {
    if (dead == 0) {
      upward = upward || reference > 0;
      downward = downward || reference < 0;
      continue;
    }
    range.low = std::min(range.low, reference);
    range.high = std::max(range.high, reference);
  }
  const bool has_point = range.low <= range.high;
  if (!dead_matters(theorem.block)) {  // the factor is a multiple: all of one sign, or none
    if (upward != downward && !has_point)
      return upward ? FactorRange{beside_zero, unbounded_end}
                    : FactorRange{-unbounded_end, -beside_zero};
    return {};
  }
  if (!has_point) return {};
  if (!proof_.actions()[theorem.block].reference) {
    if (theorem.except_dead) return {};
    return FactorRange{};
  }
  if (downward) range.low = -unbounded_end;
  if (upward) range.high = unbounded_end;
  if (theorem.except_dead && range.low == 0) range.low = beside_zero;
  if (theorem.except_dead && range.high == 0) range.high = -beside_zero;
  return range;
}

bool Conclusions::has_total(const State& state) const {
  Grip grip;
  if (proof_.refusal(state, &grip)) return false;
  const mpq_class total(*certificate_.total);
  const mpq_class off = total * mpq_class(total_tolerance);
  return grip.minimum >= total - off && grip.maximum <= total + off;
}

// The states of one pattern are a convex cone. With a total, a state of the reference load alone
// adds its own sum to any other, so it leads nowhere.
std::vector<FactorRange> Conclusions::held_by(std::size_t block) const {
  using Pattern = std::pair<support::IndexSet, support::IndexSet>;
  const bool dead_matters_here = dead_matters(block);
  std::map<Pattern, FactorRange> points;
  std::map<Pattern, std::pair<bool, bool>> directions;
  std::vector<FactorRange> all;
  for (std::size_t k = 0; k < certificate_.states.size(); ++k) {
    const auto& state = certificate_.states[k];
    if (state.block != block || !proved_.states[k]) continue;
    if (!state.share) {
      if (!certificate_.total && proof_.holds_every_load(state)) return {FactorRange{}};
      continue;
    }
    const Pattern pattern(state.contact, state.separated);
    const auto& [dead, reference] = *state.share;
    if (dead == 0) {
      if (certificate_.total) continue;
      auto& [up, down] = directions[pattern];
      up = up || reference > 0;
      down = down || reference < 0;
      continue;
    }
    if (certificate_.total && !has_total(state)) continue;
    if (!proof_.actions()[block].reference) return {FactorRange{}};
    auto [place, is_new] = points.emplace(pattern, FactorRange{reference, reference});
    place->second.low = std::min(place->second.low, reference);
    place->second.high = std::max(place->second.high, reference);
  }
  if (!dead_matters_here) all.push_back({0, 0});
  // States whose gaps can be closed are also states of the pattern in which all candidates touch.
  const auto touching = points.find(Pattern(certificate_.blocks[block], {}));
  for (const auto& [pattern, range] : points) {
    if (touching == points.end() || !proof_.closes_gaps(block, pattern.first)) continue;
    touching->second.low = std::min(touching->second.low, range.low);
    touching->second.high = std::max(touching->second.high, range.high);
  }
  for (const auto& [pattern, range] : points) all.push_back(range);
  for (const auto& [pattern, way] : directions) {
    const auto point = points.find(pattern);
    if (dead_matters_here && point == points.end()) continue;
    all.push_back(dead_matters_here ? point->second : FactorRange{0, 0});
    if (way.first) all.back().high = unbounded_end;
    if (way.second) all.back().low = -unbounded_end;
  }
  return joined(std::move(all));
}

// Without dead load and wedged configurations all reactions of a block are zero.
GripRange Conclusions::grip_of(std::size_t block) const {
  GripRange range;
  constexpr LoadShare dead{1, 0};
  const bool dead_acts = proof_.actions()[block].dead;
  if (!dead_acts) range.states = FactorRange{0, 0};
  for (std::size_t t = 0; t < certificate_.theorems.size(); ++t) {
    const auto& theorem = certificate_.theorems[t];
    if (theorem.block != block || !is_proved_empty(t)) continue;
    if (theorem.about_wedged() && !dead_acts) range.above = 0;
    if (!theorem.grip || theorem.shares != std::vector{dead}) continue;
    const double total = theorem.grip->total;
    if (theorem.grip->kind == GripBound::Kind::above)
      range.above = std::min(range.above.value_or(unbounded_end), total);
    if (theorem.grip->kind == GripBound::Kind::below) range.below = std::max(range.below, total);
  }
  for (std::size_t k = 0; k < certificate_.states.size(); ++k) {
    const auto& state = certificate_.states[k];
    Grip grip;
    if (!proved_.states[k] || state.block != block || state.share != dead ||
        proof_.refusal(state, &grip))
      continue;
    if (!range.states) range.states = FactorRange{unbounded_end, -unbounded_end};
    range.states->low = std::min(range.states->low, rounded_up(grip.maximum));
    range.states->high = std::max(range.states->high, rounded_down(grip.minimum));
  }
  return range;
}

bool Conclusions::restricts_a_sum() const {
  return std::ranges::any_of(certificate_.theorems, [](const auto& theorem) {
    return theorem.grip && theorem.grip->kind != GripBound::Kind::equal;
  });
}

// Sums of the bounds and of the states of all blocks, rounded so that they remain true.
GripRange Conclusions::grip() const {
  const auto sum = [](double one, double other, double toward) {
    if (one == 0 || other == 0) return one + other;
    return std::nextafter(one + other, toward);
  };
  GripRange whole{.below = 0, .above = 0, .states = FactorRange{0, 0}};
  for (std::size_t block = 0; block < certificate_.blocks.size(); ++block) {
    const auto own = grip_of(block);
    whole.below = sum(whole.below, own.below, 0);
    if (whole.above && own.above)
      whole.above = sum(*whole.above, *own.above, unbounded_end);
    else
      whole.above.reset();
    if (whole.states && own.states) {
      whole.states->low = sum(whole.states->low, own.states->low, unbounded_end);
      whole.states->high = sum(whole.states->high, own.states->high, 0);
    } else {
      whole.states.reset();
    }
  }
  if (proof_.work()[0].is_unbalanced()) whole.states.reset();
  return whole;
}

// Factors are held if every block holds them, and excluded if one block excludes them.
HoldClaims Conclusions::of_loads() const {
  const auto& work = proof_.work();
  HoldClaims claims{.none = out_of_equilibrium(work[0], work[1])};
  if (claims.none == std::vector{FactorRange{}}) return claims;
  claims.held = {FactorRange{}};
  claims.grip = grip();
  claims.restricts_a_sum = restricts_a_sum();
  for (std::size_t block = 0; block < certificate_.blocks.size(); ++block) {
    const auto& actions = proof_.actions()[block];
    if (certificate_.total || (actions.unconstrained && (actions.dead || actions.reference)))
      claims.held = common(claims.held, held_by(block));
  }
  if (work[0].is_unbalanced())
    claims.held.clear();
  else if (work[1].is_unbalanced())
    claims.held = common(claims.held, {{0, 0}});
  for (std::size_t t = 0; t < certificate_.theorems.size(); ++t) {
    if (!is_proved_empty(t)) continue;
    if (const auto range = excluded_by(certificate_.theorems[t])) claims.none.push_back(*range);
  }
  claims.none = joined(std::move(claims.none));
  return claims;
}

// States may miss a total by its tolerance, while theorems are about the total itself.
bool contradict(const HoldClaims& claims, bool with_total) {
  if (with_total) return false;
  if (!common(claims.held, claims.none).empty()) return true;
  const auto& [below, above, states] = claims.grip;
  if (!states) return false;
  return contains(claims.none, 0, 0) || states->low < below || (above && states->high > *above);
}

}  // namespace

Conclusion conclude(const Certificate& certificate, const Proof& proof, const Proved& proved) {
  const Conclusions conclusions(certificate, proof, proved);
  if (!certificate.loads) return conclusions.of_patterns();
  Conclusion conclusion{.loads = conclusions.of_loads()};
  // States with large displacements do not contradict theorems that leave them out.
  if (!proved.except_large_displacements &&
      contradict(*conclusion.loads, certificate.total.has_value()))
    conclusion.refusal =
        "a state and a theorem contradict each other although both are proved: the verification "
        "itself is wrong, and nothing is concluded";
  return conclusion;
}

// The work on a mode is D + R lambda. D and R may be the rounding of positions and directions in the
// file, up to a share of the magnitudes of which they consist.
std::vector<FactorRange> out_of_equilibrium(const LoadWork& dead, const LoadWork& reference) {
  constexpr double rounded = 0x1p-30;
  std::vector<FactorRange> all;
  for (std::size_t mode = 0; mode < dead.others.size(); ++mode) {
    const auto& d = dead.others[mode];
    const auto& r = reference.others[mode];
    const double dead_rounding = sgn(d) == 0 ? 0 : rounded * dead.sizes_of_others[mode];
    if (sgn(r) == 0) {
      if (std::abs(d.get_d()) > dead_rounding) all.push_back({});
      continue;
    }
    if (std::abs(r.get_d()) <= rounded * reference.sizes_of_others[mode]) continue;
    const mpq_class balance = -d / r;
    const mpq_class width = mpq_class(dead_rounding) / abs(r);
    const double low = std::nextafter(rounded_down(balance - width), -unbounded_end);
    const double high = std::nextafter(rounded_up(balance + width), unbounded_end);
    all.push_back({-unbounded_end, low});
    all.push_back({high, unbounded_end});
  }
  return joined(std::move(all));
}

bool contains(const std::vector<FactorRange>& ranges, double low, double high) {
  return std::ranges::any_of(
      ranges, [&](const auto& range) { return range.low <= low && high <= range.high; });
}

std::vector<FactorRange> common(const std::vector<FactorRange>& one,
                                const std::vector<FactorRange>& other) {
  std::vector<FactorRange> result;
  for (const auto& a : one) {
    for (const auto& b : other) {
      const FactorRange both{std::max(a.low, b.low), std::min(a.high, b.high)};
      if (both.low <= both.high) result.push_back(both);
    }
  }
  return joined(std::move(result));
}

std::vector<FactorRange> joined(std::vector<FactorRange> ranges) {
  std::ranges::sort(ranges, {}, &FactorRange::low);
  std::vector<FactorRange> result;
  for (const auto& each : ranges) {
    if (result.empty() || each.low > result.back().high) {
      result.push_back(each);
    } else {
      result.back().high = std::max(result.back().high, each.high);
    }
  }
  return result;
}

}  // namespace kusabi::verify
