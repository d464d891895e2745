// The answer for all load cases of a file: the largest of their friction coefficients, the factors
// that each of them holds.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "run/hold/hold.hpp"

namespace kusabi::run {
namespace {

using Cases = std::vector<HoldFindings>;

// @param complete every case was answered @return index of the case that needs most friction
std::size_t take_friction(HoldFindings& all, bool complete) {
  wedged::HoldingFriction found;
  found.bracket.upper = support::Bound{0, support::Standing::proved};
  found.any_by_supports = true;
  std::size_t governing = 0;
  for (std::size_t k = 0; k < all.cases.size(); ++k) {
    const auto& own = *all.cases[k].friction;
    found.status = own.status;
    found.any_by_supports = found.any_by_supports && own.any_by_supports;
    const bool more = wedged::raise_to(found.bracket, own.bracket);
    if (found.not_in_equilibrium || !(more || own.not_in_equilibrium)) continue;
    governing = k;
    found.not_in_equilibrium = own.not_in_equilibrium;
    found.maximum = own.maximum;
    found.block = own.block;
    found.pattern = own.pattern;
    found.state = own.state;
  }
  if (!complete && !found.not_in_equilibrium) {
    found.any_by_supports = false;
    found.bracket.upper.reset();
    found.pattern.reset();
    found.state.reset();
  }
  const auto needs_most = [&](const HoldFindings& each) {
    const auto& upper = each.friction->bracket.upper;
    return &each == &all.cases[governing] || (upper && upper->value <= found.bracket.at_least());
  };
  if (complete && std::ranges::all_of(all.cases, needs_most))
    all.decisive = {.largest = all.cases[governing].load_case};
  all.friction = std::move(found);
  return governing;
}

// The case that holds no factor at a coefficient, which decides alone: one of which this is proved, if
// there is one.
std::optional<std::size_t> empty_case(const Cases& cases, std::size_t point) {
  std::optional<std::size_t> empty;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (point >= cases[k].points.size()) continue;
    const auto& own = cases[k].points[point].factors;
    if (own.status != engine::Status::solved || own.unresolved || !own.intervals.empty()) continue;
    if (own.outside == support::Standing::proved) return k;
    if (!empty) empty = k;
  }
  return empty;
}

HeldPoint common_point(const Cases& cases, std::size_t point) {
  HeldPoint all = cases.front().points[point];
  for (std::size_t k = 1; k < cases.size(); ++k) {
    const auto& own = cases[k].points[point].factors;
    wedged::restrict_to(all.factors, own);
    all.factors.any_by_supports = all.factors.any_by_supports && own.any_by_supports;
    all.factors.any_by_wedging = all.factors.any_by_wedging && own.any_by_wedging;
  }
  all.factors.costs.clear();
  return all;
}

// Index of the case of which an interval has this end.
std::size_t case_with(const Cases& cases, std::size_t point, double wedged::HeldInterval::*end,
                      double value) {
  const auto found = std::ranges::find_if(cases, [&](const HoldFindings& each) {
    return std::ranges::any_of(each.points[point].factors.intervals,
                               [&](const auto& own) { return own.*end == value; });
  });
  return static_cast<std::size_t>(found - cases.begin());
}

// The states that are shown are those of one case, within what all of them hold.
void show_states(wedged::HeldFactors& found, const wedged::HeldFactors& shown) {
  for (auto& each : found.intervals) {
    const auto own = std::ranges::find_if(shown.intervals, [&](const auto& other) {
      return other.low <= each.low && each.high <= other.high;
    });
    each.pattern.reset();
    each.state.reset();
    if (own == shown.intervals.end()) continue;
    each.block = own->block;
    each.pattern = own->pattern;
    if (own->state && each.low <= own->state->factor && own->state->factor <= each.high)
      each.state = own->state;
  }
}

// @param number of all cases @return index of the case whose state is shown
std::size_t take_points(HoldFindings& all, std::size_t number) {
  using wedged::HeldInterval;
  const auto& cases = all.cases;
  const bool complete = cases.size() == number;
  std::size_t shown = 0;
  for (std::size_t k = 0; k < cases.front().points.size(); ++k) {
    all.decisive = {};
    if (const auto empty = empty_case(cases, k)) {
      shown = *empty;
      all.points.push_back(cases[shown].points[k]);
      all.points.back().factors.costs.clear();
      all.decisive.none = cases[shown].load_case;
    } else if (complete && k < cases.back().points.size()) {
      auto point = common_point(cases, k);
      auto& intervals = point.factors.intervals;
      if (!intervals.empty()) {
        const double low = intervals.front().low, high = intervals.back().high;
        const auto lower = case_with(cases, k, &HeldInterval::low, low);
        const auto upper = case_with(cases, k, &HeldInterval::high, high);
        shown = std::isfinite(high) || std::isinf(low) ? upper : lower;
        if (std::isfinite(low)) all.decisive.smallest = cases[lower].load_case;
        if (std::isfinite(high)) all.decisive.largest = cases[upper].load_case;
        show_states(point.factors, cases[shown].points[k].factors);
      }
      all.points.push_back(std::move(point));
    } else {
      break;
    }
    all.points.back().load_case = cases[shown].load_case;
  }
  if (all.points.size() != 1) all.decisive = {};
  if (all.points.empty() && cases.front().points.size() == 1) {  // ended early
    const auto& first = cases.front().points.front();
    all.points.push_back({.mu = first.mu, .load_case = cases.front().load_case, .factors = {}});
    all.points.back().factors.status = all.ended;
    all.points.back().factors.unresolved = true;
  }
  return shown;
}

// The motions of the shown case that exclude what is beyond the common answer, which ends where its
// own does, or that exclude all loads of this case.
std::vector<wedged::ExcludingMotion> exclusions_of(const HoldFindings& all,
                                                   const HoldFindings& shown) {
  using Side = wedged::ExcludedLoad::Side;
  const auto& decisive = all.decisive;
  auto motions = shown.exclusions;
  std::erase_if(motions, [&](const auto& motion) {
    if (all.friction || motion.load.side == Side::alone)
      return (all.friction ? decisive.largest : decisive.none) != shown.load_case;
    if (all.points.size() != 1 || shown.points.empty()) return true;
    const auto& common = all.points.front().factors.intervals;
    const auto& own = shown.points.front().factors.intervals;
    if (common.empty() || own.empty()) return true;
    return motion.load.side == Side::less ? common.front().low != own.front().low
                                          : common.back().high != own.back().high;
  });
  return motions;
}

}  // namespace

HoldFindings held_in_all(Cases cases, const std::vector<std::string>& names, std::size_t& shown) {
  HoldFindings all;
  all.cases = std::move(cases);
  all.ended = all.cases.back().status();
  all.of_reference = std::ranges::any_of(all.cases, &HoldFindings::of_reference);
  const bool complete = all.cases.size() == names.size() && all.ended == engine::Status::solved;
  shown =
      all.cases.front().friction ? take_friction(all, complete) : take_points(all, names.size());
  all.load_case = all.cases[shown].load_case;
  all.exclusions = exclusions_of(all, all.cases[shown]);
  for (std::size_t k = all.cases.size(); k < names.size(); ++k) {  // not answered
    HoldFindings& rest = all.cases.emplace_back();
    rest.load_case = names[k];
    if (all.friction) rest.friction.emplace();
  }
  return all;
}

}  // namespace kusabi::run
