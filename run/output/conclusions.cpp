// Words, and numbers rounded to one side.
#include "run/output/conclusions.hpp"

#include <cmath>

#include <fmt/format.h>

#include "run/output/values.hpp"

namespace kusabi::run {
namespace {

// @param way -1 down, 1 up
std::string rounded_to(double number, int way) {
  if (number == 0) return "0";
  constexpr int digits = 5;
  const int places = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(number))));
  if (places < 0 || places > 3 * digits) return fmt::format("{}", number);
  const double unit = std::pow(10, -places);
  auto text = fmt::format("{:.{}f}", number, places);
  const double shown = std::stod(text);
  if (way * (number - shown) > 0) text = fmt::format("{:.{}f}", shown + way * unit, places);
  return text;
}

}  // namespace

std::string sticking_sentence(const Sticking& found) {
  const auto where = fmt::format("friction coefficient {}", found.friction);
  if (found.count != 0U) {
    return fmt::format("It can stick: {}{} at {}.", found.whole ? "" : "at least ",
                       counted(found.count, found.thing), where);
  }
  if (found.doubtful == 0 && found.whole) return fmt::format("It cannot stick at {}.", where);
  return fmt::format("It is not known whether it can stick at {}.", where);
}

std::string doubtful_sentence(double doubtful) {
  return fmt::format(
      "Of {:.0f} sign pattern{} it could not be decided whether {} a wedged configuration; {} not "
      "counted.",
      doubtful, doubtful == 1 ? "" : "s", doubtful == 1 ? "it holds" : "they hold",
      doubtful == 1 ? "it is" : "they are");
}

std::string unsound_sentence() {
  return "Some numbers are too near to zero to tell: the lists may be wrong.";
}

std::string critical_sentence(double lower, std::optional<double> upper) {
  if (!upper && lower == 0)
    return "It is not known from which friction coefficient on it can stick.";
  if (!upper)
    return fmt::format("It cannot stick up to friction coefficient {}.", rounded_down(lower));
  if (lower > 0) {
    return fmt::format("It cannot stick below friction coefficient {}; at {} it can.",
                       rounded_down(lower), rounded_up(*upper));
  }
  return fmt::format("It can stick at friction coefficient {}.", rounded_up(*upper));
}

std::string carried_sentence(std::optional<double> factor) {
  if (!factor) return "No load factor was found at which it carries its dead load.";
  return fmt::format("It carries {} times the reference load, and no more.", rounded_down(*factor));
}

std::string always_carried_sentence(std::optional<double> lower, std::optional<double> alpha,
                                    std::optional<std::string_view> force) {
  const auto within = alpha ? fmt::format("whatever the dead load is within ± {} {}.", *alpha,
                                          force.value_or("times its uncertain part"))
                            : std::string("whatever the dead load is within its bounds.");
  if (!lower) return "No load was found that it carries " + within;
  return fmt::format("It carries at least {} times the reference load, {}", rounded_down(*lower),
                     within);
}

std::string not_carried_sentence(bool uncertain) {
  return uncertain
             ? "There is a dead load within its bounds that it does not carry at any load factor."
             : "It does not carry its dead load at any load factor.";
}

std::string rounded_down(double number) {
  return rounded_to(number, -1);
}

std::string rounded_up(double number) {
  return rounded_to(number, 1);
}

}  // namespace kusabi::run
