// Combination of the worst cases of the reference load and of its opposite.
#include "nodes/limit/guaranteed_interval.hpp"

#include <algorithm>

namespace kusabi::limit {
namespace {

using support::Bound;
using support::Bracket;
using support::Standing;

// The larger of two lower bounds, and the proved one if they are equal.
std::optional<Bound> larger(const std::optional<Bound>& one, const std::optional<Bound>& other) {
  if (!one || !other) return one ? one : other;
  if (one->value == other->value) return one->proved() ? one : other;
  return one->value > other->value ? one : other;
}

// Bracket of the larger of both numbers.
Bracket larger(const Bracket& one, const Bracket& other) {
  Bracket both{.lower = larger(one.lower, other.lower)};
  if (one.upper && other.upper)
    both.upper = Bound{std::max(one.upper->value, other.upper->value),
                       support::both(one.upper->standing, other.upper->standing)};
  return both;
}

// Nothing: neither of the two is known.
std::optional<Standing> either(std::optional<Standing> one, std::optional<Standing> other) {
  if (!one || !other) return one ? one : other;
  return support::proved_if(*one == Standing::proved || *other == Standing::proved);
}

// That of a nominal load without any factor, which is an answer only if it is proved.
std::optional<Standing> nominal_at_none(const LimitAnswer& answer) {
  if (answer.status != LoadStatus::not_carried) return {};
  return Standing::proved;
}

GuaranteedInterval of_nominal_load(const LimitAnswer& answer) {
  return {answer.nominal_factors.minimum, answer.nominal_factors.largest, nominal_at_none(answer)};
}

// From the intervals at both strengths.
GuaranteedInterval with_struts(GuaranteedInterval full, const GuaranteedInterval& residual) {
  const auto carried = residual.has_factors() ? residual : GuaranteedInterval{};
  full.minimum.upper = carried.minimum.upper;
  full.largest.lower = carried.largest.lower;
  return full;
}

}  // namespace

Standing GuaranteedInterval::standing() const {
  if (at_none) return *at_none;
  if (is_empty()) return support::proved_if(is_proved(minimum.lower) && is_proved(largest.upper));
  return support::proved_if(has_factors() && is_proved(minimum.upper) && is_proved(largest.lower));
}

std::optional<bool> GuaranteedInterval::passed() const {
  const bool proved = standing() == Standing::proved;
  if (has_factors() && proved && minimum.at_most() <= 0 && largest.at_least() >= 1) return true;
  const bool fails = (is_proved(minimum.lower) && minimum.at_least() > 0) ||
                     (is_proved(largest.upper) && largest.at_most() < 1) || (is_empty() && proved);
  return fails ? std::optional(false) : std::nullopt;
}

std::optional<Standing> at_no_factor(const LimitAnswer& answer) {
  if (!answer.worst) return nominal_at_none(answer);
  if (answer.worst->status != RootStatus::not_carried) return {};
  return answer.worst->standing;
}

GuaranteedInterval guaranteed_interval(const LimitAnswer& answer) {
  GuaranteedInterval interval;
  interval.at_none = nominal_at_none(answer);
  for (const auto* const worst : {&answer.worst, &answer.reversed}) {
    if (*worst && (*worst)->status == RootStatus::not_carried)
      interval.at_none = either(interval.at_none, (*worst)->standing);
  }
  if (interval.at_none) return interval;
  if (answer.worst) interval.largest = answer.worst->ends;
  if (answer.reversed) interval.minimum = answer.reversed->ends.negative();
  // The nominal load is admissible.
  if (!interval.largest.upper) interval.largest.upper = answer.nominal_factors.largest.upper;
  if (!interval.minimum.lower) interval.minimum.lower = answer.nominal_factors.minimum.lower;
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
    all.minimum = larger(all.minimum, each.minimum);
    all.largest = larger(all.largest.negative(), each.largest.negative()).negative();
    all.at_none = either(all.at_none, each.at_none);
  }
  return all;
}

}  // namespace kusabi::limit
