// Table and JSON of `kusabi hold`.
#include <cmath>
#include <iterator>
#include <tuple>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "problems/wedged/problem_block.hpp"
#include "run/hold/hold.hpp"
#include "run/output/rounded_within.hpp"
#include "run/results/result_scenes.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {

using nlohmann::ordered_json;

std::string contact_of(const wedged::LoadedProblem& loaded, const wedged::LoadedPattern& pattern) {
  const auto names = candidate_names(loaded.problem, pattern.contact);
  return names.empty() ? "none" : listed(names);
}

std::string contact_of(const wedged::LoadedProblem& loaded, std::uint32_t block,
                       const std::optional<wedged::LoadedPattern>& pattern) {
  if (!pattern) return "-";
  const auto own = problems::blocks_of(loaded.problem)[block];
  return contact_of(loaded, wedged::in_whole(*pattern, own));
}

ordered_json pattern_names(const wedged::LoadedProblem& loaded,
                           const wedged::LoadedPattern& pattern) {
  return {{"contact", candidate_names(loaded.problem, pattern.contact)},
          {"separated", candidate_names(loaded.problem, pattern.separated)}};
}

namespace {

ordered_json names_in_block(const wedged::LoadedProblem& loaded, std::uint32_t block,
                            const std::optional<wedged::LoadedPattern>& pattern) {
  if (!pattern) return nullptr;
  const auto own = problems::blocks_of(loaded.problem)[block];
  return pattern_names(loaded, wedged::in_whole(*pattern, own));
}

std::string grip_table(const wedged::GripRange& found) {
  if (!found.held || found.status != engine::Status::solved) return {};
  const auto minimum = support::in_table(found.minimum.out.value, found.minimum.held.value);
  if (!found.maximum.unbounded && !found.maximum.known) return {};
  if (found.maximum.unbounded)
    return fmt::format("sum of the normal reactions: {} or more, no upper bound\n", minimum.lower);
  const auto maximum = support::in_table(found.maximum.held.value, found.maximum.out.value);
  return fmt::format("sum of the normal reactions: {} to {}\n", minimum.lower, maximum.upper);
}

std::string coefficient_text(const support::Bracket& bracket) {
  const double upper = bracket.at_most();
  if (upper == 0) return "0";
  if (!bracket.lower) return "at most " + support::rounded_up(upper, support::digits_of_table);
  const auto shown = support::in_table(bracket.at_least(), upper);
  return fmt::format("between {} and {}", shown.lower, shown.upper);
}

// The ends of an interval, rounded to its inside with the digits of their brackets.
ShownEnds ends_text(const wedged::HeldInterval& each) {
  const auto& [low_out, low, high, high_out] =
      std::tie(each.low_out.value, each.low, each.high, each.high_out.value);
  auto shown = shown_ends(low, high, support::digits_of_table);
  if (low == high) return shown;
  if (std::isfinite(low) && low_out < low) shown.low = support::in_table(low_out, low).upper;
  if (std::isfinite(high) && high < high_out) shown.high = support::in_table(high, high_out).lower;
  return shown;
}

// Reactions of the candidates in contact, by their names; null if no state is known.
ordered_json state_json(const wedged::LoadedProblem& loaded, std::uint32_t block,
                        const std::optional<wedged::LoadedPattern>& pattern,
                        const std::optional<wedged::HeldState>& state) {
  if (!state || !pattern) return nullptr;
  const auto d = static_cast<std::size_t>(loaded.problem.dimension);
  const auto names = candidate_names(
      loaded.problem,
      problems::in_whole(pattern->contact, problems::blocks_of(loaded.problem)[block]));
  auto reactions = ordered_json::object();
  auto name = names.begin();
  for (const int i : pattern->contact) {
    const auto first = state->reaction.begin() + static_cast<std::ptrdiff_t>(d) * i;
    reactions[*name++] = std::vector<double>(first, first + static_cast<std::ptrdiff_t>(d));
  }
  return {{"factor", state->factor}, {"reactions", std::move(reactions)}};
}

// "normal reactions at factor 0.5: foot 0.9 top 0.3", in the unit of the file.
// @param factor "at factor 0.5"
std::string reactions_text(const wedged::LoadedProblem& loaded, std::uint32_t block,
                           const std::optional<wedged::LoadedPattern>& pattern,
                           const std::optional<wedged::HeldState>& state,
                           const std::string& factor) {
  const auto json = state_json(loaded, block, pattern, state);
  if (json.is_null()) return {};
  std::vector<std::string> parts;
  for (const auto& [name, force] : json["reactions"].items())
    parts.push_back(fmt::format("{} {:.6g}", name, force.front().get<double>()));
  return fmt::format("normal reactions {}: {}\n", factor, parts.empty() ? "none" : listed(parts));
}

}  // namespace

ordered_json costs_json(const HoldFindings& findings) {
  auto searches = ordered_json::array();
  for (const auto& cost : findings.costs()) {
    searches.push_back({{"friction", cost.friction},
                        {"low", answer::number_or_null(cost.low)},
                        {"high", answer::number_or_null(cost.high)},
                        {"opened", cost.opened},
                        {"iterations", cost.programs}});
  }
  return {{"searches", std::move(searches)}};
}

namespace {

/// The pattern and the state at an end of each interval, which the answer does not have.
ordered_json intervals_json(const wedged::LoadedProblem& loaded, const wedged::HeldFactors& found) {
  auto intervals = ordered_json::array();
  for (const auto& each : found.intervals) {
    intervals.push_back({{"pattern", names_in_block(loaded, each.block, each.pattern)},
                         {"state", state_json(loaded, each.block, each.pattern, each.state)}});
  }
  return intervals;
}

}  // namespace

ordered_json hold_json(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                       const HoldFindings& findings) {
  auto result = ordered_json::object();
  if (findings.friction) {
    const auto& found = *findings.friction;
    result["holding_friction"] = {
        {"pattern", names_in_block(loaded, found.block, found.pattern)},
        {"state", state_json(loaded, found.block, found.pattern, found.state)}};
  }
  if (options.points.size() > 1) {
    result["points"] = ordered_json::array();
    for (const auto& point : findings.points)
      result["points"].push_back({{"intervals", intervals_json(loaded, point.factors)}});
  } else if (!findings.points.empty()) {
    result["intervals"] = intervals_json(loaded, findings.points.front().factors);
  }
  if (findings.diagram) result["pieces"] = diagram_pieces(loaded, *findings.diagram);
  return result;
}

namespace {

std::string interval_row(const wedged::LoadedProblem& loaded, const std::string& first,
                         const wedged::HeldInterval& each) {
  const auto shown = ends_text(each);
  return fmt::format("{}  {:>18}  {:>18}  {:<15}  {}\n", first, shown.low, shown.high,
                     standing_of(each), contact_of(loaded, each.block, each.pattern));
}

std::string interval_head(const std::string& first) {
  return fmt::format("\n{}  {:>18}  {:>18}  {:<15}  {}\n", first, "held from", "held to",
                     "standing", "in contact at an end");
}

std::string point_table(const wedged::LoadedProblem& loaded, const HeldPoint& point) {
  auto text = interval_head(fmt::format("{:>5}", ""));
  std::size_t number = 0;
  for (const auto& each : point.factors.intervals)
    text += interval_row(loaded, fmt::format("{:>5}", ++number), each);
  for (const auto& each : point.factors.intervals) {
    if (!each.state) continue;
    text += reactions_text(loaded, each.block, each.pattern, each.state,
                           under_factor(each.state->factor, each.low, each.high));
  }
  text += fmt::format("(factors of the reference load at friction coefficient {})\n", point.mu);
  if (point.grip) text += grip_table(*point.grip);
  return text;
}

// One row for each interval, and one for a coefficient without any.
std::string points_table(const wedged::LoadedProblem& loaded,
                         const std::vector<HeldPoint>& points) {
  auto text = interval_head(fmt::format("{:>8}", "mu"));
  for (const auto& point : points) {
    const auto mu = fmt::format("{:>8}", point.mu);
    for (const auto& each : point.factors.intervals) text += interval_row(loaded, mu, each);
    if (point.factors.intervals.empty())
      text += fmt::format("{}  {:>18}  {:>18}  {}\n", mu, "-", "-", standing_of_none(point));
  }
  text += "(factors of the reference load at friction coefficients mu)\n";
  for (const auto& point : points) {
    const auto grip = point.grip ? grip_table(*point.grip) : std::string();
    if (!grip.empty()) text += fmt::format("at {}: {}", point.mu, grip);
  }
  return text;
}

}  // namespace

std::string hold_table(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                       const HoldFindings& findings) {
  std::string text;
  const auto out = std::back_inserter(text);
  if (findings.friction) {
    const auto& found = *findings.friction;
    if (found.bracket.upper) {
      fmt::format_to(out, "\nholding friction coefficient: {}\nin contact: {}\n",
                     coefficient_text(found.bracket),
                     contact_of(loaded, found.block, found.pattern));
      text +=
          reactions_text(loaded, found.block, found.pattern, found.state, under_factor(0, 0, 0));
    }
  } else if (findings.diagram) {
    text += diagram_table(loaded, *findings.diagram);
  } else if (options.points.size() > 1) {
    text += points_table(loaded, findings.points);
  } else {
    text += point_table(loaded, findings.points.front());
  }
  std::uint64_t opened = 0;
  for (const auto& cost : findings.costs()) opened += cost.opened;
  fmt::format_to(out, "\n{}, {}\n", answer::counted(findings.costs().size(), "tree"),
                 answer::counted(opened, "node"));
  return text;
}

}  // namespace kusabi::run
