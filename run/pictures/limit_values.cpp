// Bounds are rounded outwards, each with its standing.
#include "run/pictures/limit_values.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/fields.hpp"
#include "answer/values.hpp"
#include "answer/words.hpp"
#include "problems/limit/collapse_mode.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using limit::GuaranteedInterval;
using limit::LoadCurve;
using nlohmann::ordered_json;
using problems::LimitProblem;

/// Significant digits in the table of a curve.
constexpr int digits_of_place = 8;
constexpr int digits_of_factor = 10;

// Distance within which the curve passes the points of its table, if it is proved.
std::string distance_text(const LoadCurve& curve) {
  constexpr double shift = 1e-7;   // of a place by rounding, relative
  constexpr double change = 1e-9;  // of a factor by rounding, relative
  double error = 0;
  double slope = 0;
  double largest = std::abs(curve.pieces.back().factor_at_end);
  for (const auto& piece : curve.pieces) {
    if (!piece.error)
      return fmt::format("the factors are those of the simplex method{}\n",
                         answer::unless_proved(support::Standing::computed));
    error = std::max(error, *piece.error);
    slope = std::max(slope, std::abs(piece.from.slope));
    largest = std::max(largest, std::abs(piece.from.factor));
  }
  error += shift * slope * curve.pieces.back().to + change * largest;
  return fmt::format("each factor is within {} of that of the curve, {}\n",
                     support::rounded_up(error, 2),
                     answer::standing_word(support::Standing::proved));
}

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
  if (interval.is_empty())
    return fmt::format("there is no factor that is carried{}, {}", loads, standing);
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

ordered_json interval_json(const GuaranteedInterval& interval) {
  return {{"minimum", answer::written(interval.minimum)},
          {"maximum", answer::written(interval.largest)}};
}

NamedMode named_mode(const LimitProblem& problem, const Eigen::VectorXd& motion) {
  const auto mode = problems::collapse_mode(problem, motion);
  NamedMode named{.moving = mode.moving.size(), .along_reference = mode.along_reference};
  for (const auto& [member, elongation] : mode.yielding) {
    named.yielding.push_back(problems::member_name(problem, member));
    (elongation > 0 ? named.tension : named.compression).push_back(named.yielding.back());
  }
  return named;
}

std::string yielding_text(const NamedMode& mode, int indent) {
  std::string text;
  const auto add = [&](const char* title, const std::vector<std::string>& members) {
    if (members.empty()) return;
    fmt::format_to(std::back_inserter(text), "{:{}}in {:<13}{}\n", "", indent, title,
                   fmt::join(members, " "));
  };
  add("tension:", mode.tension);
  add("compression:", mode.compression);
  return text;
}

std::string curve_text(const LimitProblem& problem, const LoadCurve& curve,
                       std::string_view variable, std::string_view load, double scale) {
  constexpr int indent = 29;  // column of the modes
  std::string text =
      fmt::format("{:>12} {:>14}  collapse mode above this {}\n", variable, "factor", variable);
  const auto out = std::back_inserter(text);
  const auto row = [&](double at, double factor) {
    fmt::format_to(out, "{:>12} {:>14.{}g}", support::rounded_down(scale * at, digits_of_place),
                   factor, digits_of_factor);
  };
  for (const auto& piece : curve.pieces) {
    const auto mode = named_mode(problem, piece.from.motion);
    row(piece.from.at, piece.from.factor);
    fmt::format_to(out, "  {} yielding{}\n", answer::counted(mode.yielding.size(), "member"),
                   mode.along_reference ? ", along the reference load" : "");
    text += yielding_text(mode, indent);
  }
  row(curve.pieces.back().to, curve.pieces.back().factor_at_end);
  text += '\n';
  if (const auto& end = curve.end)
    fmt::format_to(out, "{:>12}  {} is carried at no factor from here on, {}\n",
                   support::rounded_up(scale * end->not_carried_at, digits_of_place), load,
                   answer::standing_word(end->standing));
  return text + distance_text(curve);
}

void add_curve(ordered_json& result, const std::string& key, const LimitProblem& problem,
               const LoadCurve& curve, double scale) {
  auto pieces = ordered_json::array();
  for (const auto& piece : curve.pieces) {
    auto mode = named_mode(problem, piece.from.motion);
    pieces.push_back({{"from", scale * piece.from.at},
                      {"to", scale * piece.to},
                      {"factor_from", piece.from.factor},
                      {"factor_to", piece.factor_at_end},
                      {"error", answer::number_or_null(piece.error)},
                      {"along_reference_load", mode.along_reference},
                      {"yielding", std::move(mode.yielding)},
                      {"tension", std::move(mode.tension)}});
  }
  result[key] = std::move(pieces);
  if (!curve.end) return;
  result[key + "_end"] = {{"carried_at", scale * curve.end->carried_at},
                          {"not_carried_at", scale * curve.end->not_carried_at},
                          {"standing", answer::name_of(curve.end->standing)}};
}

}  // namespace kusabi::run
