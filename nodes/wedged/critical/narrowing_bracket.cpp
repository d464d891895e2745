// Updates of the bracket, and the line that reports it.
#include "nodes/wedged/critical/narrowing_bracket.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "support/rounded_bounds.hpp"

namespace kusabi::wedged {
namespace {

/// Duration in seconds below which a run shows no intermediate brackets.
constexpr double short_run = 0.5;

/// Relative tolerance for brackets of one cell: bounds are rounded multiples of the width.
constexpr double rounding_of_ends = 1e-9;

}  // namespace

std::optional<double> NarrowingBracket::upper() const {
  if (!bracket_.upper) return {};
  return bracket_.upper->value;
}

bool NarrowingBracket::is_one_cell(double width) const {
  return bracket_.width() <= width * (1 + rounding_of_ends);
}

void NarrowingBracket::raise_lower(double lower) {
  if (lower > this->lower()) move_lower(lower);
}

void NarrowingBracket::reduce_upper(double upper, const PatternNode& leaf) {
  upper = std::max(upper, minimum_);
  if (upper < upper_or_infinity()) move_upper(upper, leaf);
}

void NarrowingBracket::prove_lower(double lower) {
  bracket_.lower = {lower, support::Standing::proved};
  changed_ = true;
}

void NarrowingBracket::prove_upper(double upper, const PatternNode& leaf) {
  bracket_.upper = {upper, support::Standing::proved};
  leaf_ = leaf;
  changed_ = true;
}

void NarrowingBracket::move_lower(double lower) {
  bracket_.lower = {lower, support::proved_if(lower == 0)};
  changed_ = true;
}

void NarrowingBracket::move_upper(std::optional<double> upper) {
  bracket_.upper.reset();
  if (upper) bracket_.upper = support::Bound{*upper};
  changed_ = true;
}

void NarrowingBracket::move_upper(double upper, const PatternNode& leaf) {
  move_upper(upper);
  leaf_ = leaf;
}

void NarrowingBracket::show() {
  if (!changed_ || analysis_.seconds() < short_run) return;
  changed_ = false;
  const auto bound = [](const std::string& number, bool proved) {
    return fmt::format("{} ({})", number, proved ? "proved" : "not yet proved");
  };
  constexpr int digits = 9;
  const auto lower =
      "cannot stick up to " + bound(support::rounded_down(this->lower(), digits), lower_proved());
  analysis_.say(
      upper() ? fmt::format("bracket so far: {}, sticks at {}", lower,
                            bound(support::rounded_up(*upper(), digits), upper_proved()))
              : fmt::format("bracket so far: {}, no pattern known up to {:.9g}", lower, maximum_));
}

}  // namespace kusabi::wedged
