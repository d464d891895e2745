// Decimal places are chosen first, then each bound is rounded outwards.
#include "support/rounded_bounds.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace kusabi::support {
namespace {

/// Numbers with more decimal places than these are shown with a power of ten.
constexpr int max_places = 15;
/// A double has no more significant digits.
constexpr int all_digits = 17;
/// Smaller numbers are shown as zero or as this one: they have fewer digits the closer they are to
/// the end of the range of doubles, and no quantity is that small.
constexpr double least_shown = 1e-300;

int places_of(double number, int digits) {
  if (number == 0 || !std::isfinite(number)) return 0;
  return digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(number))));
}

// The number of a text made by fmt, which has a decimal point in any locale.
double value_of(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// Trailing zeros are removed, and the sign of minus zero.
std::string trimmed(std::string number) {
  if (number.find('.') != std::string::npos && number.find('e') == std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    if (number.ends_with('.')) number.pop_back();
  }
  return number == "-0" ? "0" : number;
}

// "4.869e-96". @param way -1: down, 1: up
std::string with_power(double number, int digits, int way) {
  auto text = fmt::format("{:.{}e}", number, digits - 1);
  const double shown = value_of(text);
  if (way * (number - shown) > 0) {
    const double last = std::pow(10, std::floor(std::log10(std::abs(shown))) - digits + 1);
    text = fmt::format("{:.{}e}", shown + way * last, digits - 1);
  }
  const auto power = text.find('e');
  return trimmed(text.substr(0, power)) + text.substr(power);
}

// Beside a tiny bound, one of ordinary size has its own places: "-5.1235", not "-5.1235e+00".
// @param digits for numbers with a power of ten @param way -1: down, 1: up
std::string rounded(double number, int places, int digits, int way) {
  if (number == 0) return "0";
  if (std::abs(number) < least_shown)
    return way * number < 0 ? "0" : fmt::format("{}", way * least_shown);
  if (!std::isfinite(number) || places < 0) return fmt::format("{}", number);
  if (places > max_places) places = places_of(number, digits);
  if (places > max_places) return with_power(number, std::min(digits, all_digits), way);
  auto text = fmt::format("{:.{}f}", number, places);
  const double shown = value_of(text);
  if (way * (number - shown) > 0)
    text = fmt::format("{:.{}f}", shown + way * std::pow(10, -places), places);
  return trimmed(std::move(text));
}

}  // namespace

std::string rounded_down(double number, int digits) {
  return rounded(number, places_of(number, digits), digits, -1);
}

std::string rounded_up(double number, int digits) {
  return rounded(number, places_of(number, digits), digits, 1);
}

ShownBracket in_sentence(double lower, double upper, int digits) {
  const int places = std::max(places_of(lower, digits), places_of(upper, digits));
  return {rounded(lower, places, digits, -1), rounded(upper, places, digits, 1)};
}

ShownBracket inside(double low, double high, int digits) {
  for (; digits < all_digits; ++digits) {
    ShownBracket shown{rounded_up(low, digits), rounded_down(high, digits)};
    if (value_of(shown.lower) <= value_of(shown.upper)) return shown;
  }
  return {fmt::format("{}", low), fmt::format("{}", high)};
}

ShownBracket in_table(double lower, double upper) {
  for (int digits = digits_of_table; digits < all_digits; ++digits) {
    auto shown = in_sentence(lower, upper, digits);
    const double width = value_of(shown.upper) - value_of(shown.lower);
    if (width <= 2 * std::max(upper - lower, least_shown)) return shown;
  }
  return {fmt::format("{}", lower), fmt::format("{}", upper)};
}

}  // namespace kusabi::support
