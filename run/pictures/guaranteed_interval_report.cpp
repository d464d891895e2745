// Bounds of both ends, each with its standing.
#include "run/pictures/guaranteed_interval_report.hpp"

#include <cmath>

#include <fmt/format.h>

#include "run/output/values.hpp"

namespace kusabi::run {
namespace {

using limit::FactorBracket;
using limit::GuaranteedInterval;
using nlohmann::ordered_json;

ordered_json bracket_json(const FactorBracket& bracket) {
  return {{"lower", number_or_null(bracket.lower)},
          {"upper", number_or_null(bracket.upper)},
          {"lower_proved", bracket.lower_proved},
          {"upper_proved", bracket.upper_proved}};
}

const char* proved_word(bool proved) {
  return proved ? "proved" : "not proved";
}

std::string bound_text(double bound) {
  return std::isfinite(bound) ? fmt::format("{:.10g}", bound) : std::string("unknown");
}

}  // namespace

std::string interval_text(const GuaranteedInterval& interval, std::string_view loads) {
  if (interval.is_empty()) {
    return fmt::format("no factor is carried{}, {}", loads, proved_word(interval.decided()));
  }
  const auto& [minimum, largest, at_none, at_none_proved] = interval;
  if (interval.has_factors()) {
    return fmt::format("factors {:.10g} ... {:.10g} are carried{}, {}", minimum.upper,
                       largest.lower, loads, proved_word(interval.decided()));
  }
  return fmt::format("open: factors carried{} lie between {} and {}; their existence is undecided",
                     loads, bound_text(minimum.lower), bound_text(largest.upper));
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
