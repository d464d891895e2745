// Updates of the bracket, and the line that reports it.
#include "nodes/wedged/critical/narrowing_bracket.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace kusabi::wedged {
namespace {

/// Duration in seconds below which a run shows no intermediate brackets.
constexpr double short_run = 0.5;

/// Relative tolerance for brackets of one cell: bounds are rounded multiples of the width.
constexpr double rounding_of_ends = 1e-9;

}  // namespace

std::optional<double> NarrowingBracket::upper() const {
  if (!upper_) return {};
  return upper_->value;
}

bool NarrowingBracket::is_one_cell(double width) const {
  return bracket().width() <= width * (1 + rounding_of_ends);
}

void NarrowingBracket::raise_lower(double lower) {
  if (lower > lower_.value) move_lower(lower);
}

void NarrowingBracket::reduce_upper(double upper, const PatternNode& leaf) {
  upper = std::max(upper, minimum_);
  if (upper < upper_or_infinity()) move_upper(upper, leaf);
}

void NarrowingBracket::prove_lower(double lower) {
  lower_ = {lower, support::Standing::proved};
  changed_ = true;
}

void NarrowingBracket::prove_upper(double upper, const PatternNode& leaf) {
  upper_ = {upper, support::Standing::proved};
  leaf_ = leaf;
  changed_ = true;
}

void NarrowingBracket::move_lower(double lower) {
  lower_ = {lower, support::proved_if(lower == 0)};
  changed_ = true;
}

void NarrowingBracket::move_upper(std::optional<double> upper) {
  upper_.reset();
  if (upper) upper_ = support::Bound{*upper};
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
  const auto lower =
      fmt::format("cannot stick up to {:.9g} ({})", lower_.value, proof(lower_proved()));
  analysis_.say(
      upper_ ? fmt::format("bracket so far: {}, sticks at {:.9g} ({})", lower, upper_->value,
                           proof(upper_->proved()))
             : fmt::format("bracket so far: {}, no pattern known up to {:.9g}", lower, maximum_));
}

}  // namespace kusabi::wedged
