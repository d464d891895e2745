// Bounds of both ends, each with its standing.
#include "run/pictures/guaranteed_interval_report.hpp"

#include <utility>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using limit::GuaranteedInterval;
using nlohmann::ordered_json;

ordered_json bracket_json(const support::Bracket& bracket) {
  return {{"lower", answer::number_or_null(bracket.at_least())},
          {"upper", answer::number_or_null(bracket.at_most())},
          {"lower_proved", is_proved(bracket.lower)},
          {"upper_proved", is_proved(bracket.upper)}};
}

const char* proved_word(support::Standing standing) {
  return is_proved(standing) ? "proved" : "not proved";
}

}  // namespace

std::string factor_text(const support::Bracket& factor) {
  const auto& [lower, upper] = factor;
  if (lower && upper) {
    const auto shown = support::in_table(lower->value, upper->value);
    if (lower->standing == upper->standing)
      return fmt::format("{} ... {}, {}", shown.lower, shown.upper, proved_word(lower->standing));
    return fmt::format("{} ({}) ... {} ({})", shown.lower, proved_word(lower->standing),
                       shown.upper, proved_word(upper->standing));
  }
  if (lower)
    return fmt::format("at least {}, {}; open above",
                       support::rounded_down(lower->value, support::digits_of_table),
                       proved_word(lower->standing));
  if (upper)
    return fmt::format("at most {}, {}; open below",
                       support::rounded_up(upper->value, support::digits_of_table),
                       proved_word(upper->standing));
  return "open";
}

std::string interval_text(const GuaranteedInterval& interval, std::string_view loads) {
  const auto proved = proved_word(interval.standing());
  if (interval.is_empty()) return fmt::format("no factor is carried{}, {}", loads, proved);
  const auto& [minimum, largest, at_none] = interval;
  if (interval.has_factors()) {
    const auto [low, high] =
        support::inside(minimum.at_most(), largest.at_least(), support::digits_of_table);
    return fmt::format("factors {} ... {} are carried{}, {}", low, high, loads, proved);
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
  const char* const answer = !passed ? "open" : *passed ? "passed, proved" : "not passed, proved";
  return fmt::format("every load factor from 0 to 1: {}", answer);
}

ordered_json interval_json(const GuaranteedInterval& interval) {
  const auto known = [&]() -> ordered_json {
    if (interval.is_empty()) return true;
    if (interval.has_factors()) return false;
    return {};
  };
  return {{"lower", bracket_json(interval.minimum)},
          {"upper", bracket_json(interval.largest)},
          {"empty", known()},
          {"passed", interval.passed() ? ordered_json(*interval.passed()) : ordered_json()},
          {"proved", is_proved(interval.standing())}};
}

}  // namespace kusabi::run
