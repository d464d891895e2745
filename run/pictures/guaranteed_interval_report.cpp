// Bounds of both ends, each with its standing.
#include "run/pictures/guaranteed_interval_report.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "answer/shown_bracket.hpp"
#include "answer/values.hpp"

namespace kusabi::run {
namespace {

using limit::FactorBracket;
using limit::GuaranteedInterval;
using nlohmann::ordered_json;

ordered_json bracket_json(const FactorBracket& bracket) {
  return {{"lower", answer::number_or_null(bracket.lower)},
          {"upper", answer::number_or_null(bracket.upper)},
          {"lower_proved", bracket.lower_proved},
          {"upper_proved", bracket.upper_proved}};
}

const char* proved_word(bool proved) {
  return proved ? "proved" : "not proved";
}

}  // namespace

std::string factor_text(double lower, double upper) {
  if (std::isfinite(lower) && std::isfinite(upper)) {
    const auto shown = answer::in_table(lower, upper);
    return fmt::format("{} ... {}, proved", shown.lower, shown.upper);
  }
  if (std::isfinite(lower))
    return fmt::format("at least {}, proved; open above",
                       answer::rounded_down(lower, answer::digits_of_table));
  if (std::isfinite(upper))
    return fmt::format("at most {}, proved; open below",
                       answer::rounded_up(upper, answer::digits_of_table));
  return "open";
}

std::string interval_text(const GuaranteedInterval& interval, std::string_view loads) {
  if (interval.is_empty()) {
    return fmt::format("no factor is carried{}, {}", loads, proved_word(interval.decided()));
  }
  const auto& [minimum, largest, at_none, at_none_proved] = interval;
  if (interval.has_factors()) {
    const auto [low, high] = answer::inside(minimum.upper, largest.lower, answer::digits_of_table);
    return fmt::format("factors {} ... {} are carried{}, {}", low, high, loads,
                       proved_word(interval.decided()));
  }
  const auto known = [](double bound, std::string text) {
    return std::isfinite(bound) ? std::move(text) : std::string("unknown");
  };
  return fmt::format(
      "open: factors carried{} lie between {} and {}; their existence is undecided", loads,
      known(minimum.lower, answer::rounded_down(minimum.lower, answer::digits_of_table)),
      known(largest.upper, answer::rounded_up(largest.upper, answer::digits_of_table)));
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
          {"proved", interval.decided()}};
}

}  // namespace kusabi::run
