// The nearest decimal number is tried before those beside it.
#include "run/output/rounded_within.hpp"

#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

constexpr int all_digits = 17;          ///< a double has no more
constexpr int digits_of_friction = 10;  ///< of a coefficient of the call, or a bound that is found

double value_of(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

std::string rounded_within(double number, double low, double high, int digits) {
  for (; digits < all_digits; ++digits) {
    for (auto text : {fmt::format("{:.{}g}", number, digits), support::rounded_down(number, digits),
                      support::rounded_up(number, digits)}) {
      const double shown = value_of(text);
      if (low <= shown && shown <= high) return text;
    }
  }
  return fmt::format("{}", number);
}

bool is_all_friction(double needed, double friction) {
  constexpr double rounding = 1e-9;
  return needed >= friction * (1 - rounding);
}

std::string needed_friction_text(double needed, double friction, int digits) {
  if (is_all_friction(needed, friction)) return support::rounded_up(friction, digits_of_friction);
  return rounded_within(needed, needed, friction, digits);
}

ShownEnds shown_ends(double low, double high, int digits) {
  if (low == high) return {fmt::format("{}", low), fmt::format("{}", high)};
  if (std::isfinite(low) && std::isfinite(high)) {
    auto [from, to] = support::inside(low, high, digits);
    return {std::move(from), std::move(to)};
  }
  const auto text = [](double end, const std::string& rounded) {
    return std::isinf(end) ? std::string("no end") : rounded;
  };
  return {text(low, support::rounded_up(low, digits)),
          text(high, support::rounded_down(high, digits))};
}

}  // namespace kusabi::run
