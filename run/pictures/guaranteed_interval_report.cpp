// Bounds of both ends, each with its standing.
#include "run/pictures/guaranteed_interval_report.hpp"

#include <utility>

#include <fmt/format.h>

#include "answer/fields.hpp"
#include "answer/words.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using limit::GuaranteedInterval;
using nlohmann::ordered_json;

}  // namespace

std::string factor_text(const support::Bracket& factor) {
  const auto& [lower, upper] = factor;
  if (lower && upper) {
    const auto shown = support::in_table(lower->value, upper->value);
    if (lower->standing == upper->standing)
      return fmt::format("{} ... {}, {}", shown.lower, shown.upper,
                         answer::standing_word(lower->standing));
    return fmt::format("{} ({}) ... {} ({})", shown.lower, answer::standing_word(lower->standing),
                       shown.upper, answer::standing_word(upper->standing));
  }
  if (lower)
    return fmt::format("at least {}, {}; open above",
                       support::rounded_down(lower->value, support::digits_of_table),
                       answer::standing_word(lower->standing));
  if (upper)
    return fmt::format("at most {}, {}; open below",
                       support::rounded_up(upper->value, support::digits_of_table),
                       answer::standing_word(upper->standing));
  return "open";
}

std::string interval_text(const GuaranteedInterval& interval, std::string_view loads) {
  const auto* const standing = answer::standing_word(interval.standing());
  if (interval.is_empty()) return fmt::format("no factor is carried{}, {}", loads, standing);
  const auto& [minimum, largest, at_none] = interval;
  if (interval.has_factors()) {
    const auto [low, high] =
        support::inside(minimum.at_most(), largest.at_least(), support::digits_of_table);
    return fmt::format("factors {} ... {} are carried{}, {}", low, high, loads, standing);
  }
  const std::string unknown = "unknown";
  return fmt::format(
      "open: factors carried{} lie between {} and {}; their existence is undecided", loads,
      minimum.lower ? support::rounded_down(minimum.lower->value, support::digits_of_table)
                    : unknown,
      largest.upper ? support::rounded_up(largest.upper->value, support::digits_of_table)
                    : unknown);
}

std::string passed_text(const GuaranteedInterval& interval) {
  const auto passed = interval.passed();
  if (!passed) return "every load factor from 0 to 1: open";
  return fmt::format("every load factor from 0 to 1: {}passed, {}", *passed ? "" : "not ",
                     answer::standing_word(support::Standing::proved));
}

ordered_json worst_case_json(const limit::LimitWorstCase& worst) {
  auto json = answer::written(worst.ends);
  json["standing"] = answer::name_of(worst.standing);
  return json;
}

ordered_json interval_json(const GuaranteedInterval& interval) {
  const auto known = [&]() -> ordered_json {
    if (interval.is_empty()) return true;
    if (interval.has_factors()) return false;
    return {};
  };
  return {{"lower", answer::written(interval.minimum)},
          {"upper", answer::written(interval.largest)},
          {"empty", known()},
          {"passed", interval.passed() ? ordered_json(*interval.passed()) : ordered_json()},
          {"standing", answer::name_of(interval.standing())}};
}

}  // namespace kusabi::run
