// Combination of the worst cases of the reference load and of its opposite.
#include "nodes/limit/guaranteed_interval.hpp"

#include <algorithm>
#include <cmath>

namespace kusabi::limit {
namespace {

// The bounds of a worst case with the opposite reference load, in terms of the original one.
FactorBracket reversed(const LimitEnds& ends) {
  return negative({ends.lower, ends.upper, ends.lower_proved, ends.upper_proved});
}

// Keeps the larger of two lower bounds, and the proved one if they are equal.
void raise(double& bound, bool& proved, double other, bool other_proved) {
  if (other < bound || (other == bound && proved)) return;
  bound = other;
  proved = other_proved;
}

// Bracket of the larger of both numbers.
void raise(FactorBracket& one, const FactorBracket& other) {
  raise(one.lower, one.lower_proved, other.lower, other.lower_proved);
  one.upper = std::max(one.upper, other.upper);
  one.upper_proved = one.upper_proved && other.upper_proved;
}

GuaranteedInterval of_nominal_load(const LimitAnswer& answer) {
  GuaranteedInterval interval;
  interval.at_none = interval.at_none_proved = answer.status == LoadStatus::not_carried;
  interval.minimum = answer.nominal_factors.minimum;
  interval.largest = answer.nominal_factors.largest;
  return interval;
}

// From the intervals at both strengths.
GuaranteedInterval with_struts(GuaranteedInterval full, const GuaranteedInterval& residual) {
  const auto carried = residual.has_factors() ? residual : GuaranteedInterval{};
  full.minimum.upper = carried.minimum.upper;
  full.minimum.upper_proved = carried.minimum.upper_proved;
  full.largest.lower = carried.largest.lower;
  full.largest.lower_proved = carried.largest.lower_proved;
  return full;
}

}  // namespace

bool GuaranteedInterval::decided() const {
  if (at_none) return at_none_proved;
  if (is_empty()) return minimum.lower_proved && largest.upper_proved;
  return has_factors() && minimum.upper_proved && largest.lower_proved;
}

std::optional<bool> GuaranteedInterval::passed() const {
  if (has_factors() && minimum.upper_proved && largest.lower_proved && minimum.upper <= 0 &&
      largest.lower >= 1) {
    return true;
  }
  const bool fails = at_none_proved || (minimum.lower_proved && minimum.lower > 0) ||
                     (largest.upper_proved && largest.upper < 1) || (is_empty() && decided());
  return fails ? std::optional(false) : std::nullopt;
}

GuaranteedInterval guaranteed_interval(const LimitAnswer& answer) {
  GuaranteedInterval interval;
  if (!answer.worst) {
    interval.at_none = interval.at_none_proved = answer.status == LoadStatus::not_carried;
    return interval;
  }
  for (const auto* const worst : {&answer.worst, &answer.reversed}) {
    if (!*worst || (*worst)->status != RootStatus::not_carried) continue;
    interval.at_none = true;
    interval.at_none_proved = interval.at_none_proved || (*worst)->proved;
  }
  if (interval.at_none) return interval;
  const auto& ends = answer.worst->ends;
  interval.largest = {ends.lower, ends.upper, ends.lower_proved, ends.upper_proved};
  if (answer.reversed) {
    interval.minimum = reversed(answer.reversed->ends);
  } else {
    // The nominal load is admissible.
    const auto& nominal = answer.nominal_factors.minimum;
    raise(interval.minimum.lower, interval.minimum.lower_proved, nominal.lower,
          nominal.lower_proved);
  }
  return interval;
}

GuaranteedInterval guaranteed_interval(const LimitAnswer& answer,
                                       const std::optional<LimitAnswer>& residual) {
  const auto full = guaranteed_interval(answer);
  return residual ? with_struts(full, guaranteed_interval(*residual)) : full;
}

GuaranteedInterval nominal_interval(const LimitAnswer& answer,
                                    const std::optional<LimitAnswer>& residual) {
  const auto full = of_nominal_load(answer);
  return residual ? with_struts(full, of_nominal_load(*residual)) : full;
}

GuaranteedInterval intersection(std::span<const GuaranteedInterval> cases) {
  auto all = cases.front();
  for (const auto& each : cases.subspan(1)) {
    raise(all.minimum, each.minimum);
    auto largest = negative(all.largest);
    raise(largest, negative(each.largest));
    all.largest = negative(largest);
    all.at_none = all.at_none || each.at_none;
    all.at_none_proved = all.at_none_proved || each.at_none_proved;
  }
  return all;
}

}  // namespace kusabi::limit
