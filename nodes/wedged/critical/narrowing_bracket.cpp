// Updates of the bracket, and the line that reports it.
#include "nodes/wedged/critical/narrowing_bracket.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace kusabi::wedged {
namespace {

/// Duration in seconds below which a run shows no intermediate brackets.
constexpr double short_run = 0.5;

/// Relative tolerance for brackets of one cell: bounds are rounded multiples of the width.
constexpr double rounding_of_ends = 1e-9;

}  // namespace

double NarrowingBracket::upper_or_infinity() const {
  return upper_.value_or(std::numeric_limits<double>::infinity());
}

bool NarrowingBracket::is_one_cell(double width) const {
  return upper_or_infinity() - lower_ <= width * (1 + rounding_of_ends);
}

void NarrowingBracket::raise_lower(double lower) {
  if (!(lower > lower_)) return;
  lower_ = lower;
  lower_proved_ = false;
  changed_ = true;
}

void NarrowingBracket::reduce_upper(double upper, const PatternNode& leaf) {
  upper = std::max(upper, minimum_);
  if (!(upper < upper_or_infinity())) return;
  upper_ = upper;
  leaf_ = leaf;
  upper_proved_ = false;
  changed_ = true;
}

void NarrowingBracket::prove_lower(double lower) {
  lower_ = lower;
  lower_proved_ = true;
  changed_ = true;
}

void NarrowingBracket::prove_upper(double upper, const PatternNode& leaf) {
  upper_ = upper;
  leaf_ = leaf;
  upper_proved_ = true;
  changed_ = true;
}

void NarrowingBracket::move_lower(double lower) {
  lower_ = lower;
  lower_proved_ = false;
  changed_ = true;
}

void NarrowingBracket::move_upper(std::optional<double> upper) {
  upper_ = upper;
  upper_proved_ = false;
  changed_ = true;
}

void NarrowingBracket::move_upper(double upper, const PatternNode& leaf) {
  move_upper(upper);
  leaf_ = leaf;
}

void NarrowingBracket::show() {
  if (!changed_ || analysis_.seconds() < short_run) return;
  changed_ = false;
  const auto proof = [](bool proved) { return proved ? "proved" : "not yet proved"; };
  const auto lower = fmt::format("cannot stick up to {:.9g} ({})", lower_, proof(lower_proved()));
  analysis_.say(
      upper_ ? fmt::format("bracket so far: {}, sticks at {:.9g} ({})", lower, *upper_,
                           proof(upper_proved_))
             : fmt::format("bracket so far: {}, no pattern known up to {:.9g}", lower, maximum_));
}

}  // namespace kusabi::wedged
