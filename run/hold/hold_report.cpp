// Table and JSON of `kusabi hold`.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
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

// Velocities of a large structure are left out.
ordered_json exclusions_json(const wedged::LoadedProblem& loaded,
                             const problems::Structure& structure,
                             const std::vector<wedged::ExcludingMotion>& exclusions) {
  constexpr Eigen::Index most_nodes = 5000;
  auto list = ordered_json::array();
  for (const auto& motion : exclusions) {
    auto bodies = ordered_json::array();
    for (const auto& body : motion.bodies.bodies)
      bodies.push_back({{"node", body.node}, {"motion", body.words}});
    auto moving = ordered_json::array();
    const Eigen::Index nodes = motion.bodies.velocities.cols();
    for (Eigen::Index node = 0; node < nodes && nodes <= most_nodes; ++node) {
      const Eigen::VectorXd velocity = motion.bodies.velocities.col(node);
      if (velocity.isZero(0)) continue;
      moving.push_back({{"node", structure.node_names[static_cast<std::size_t>(node)]},
                        {"velocity", std::vector<double>(velocity.begin(), velocity.end())}});
    }
    list.push_back({{"friction", motion.load.friction},
                    {"factor", motion.load.share.reference},
                    {"bodies", std::move(bodies)},
                    {"sliding", candidate_names(loaded.problem, motion.sliding)},
                    {"opening", candidate_names(loaded.problem, motion.opening)},
                    {"moving", std::move(moving)}});
  }
  return list;
}

}  // namespace

std::vector<wedged::ExcludedLoad> excluded_loads(const HoldOptions& options,
                                                 const wedged::LoadedProblem& loaded,
                                                 const HoldFindings& findings) {
  using Side = wedged::ExcludedLoad::Side;
  constexpr wedged::LoadShare dead_alone{1, 0};
  if (findings.status() != engine::Status::solved) return {};
  if (findings.friction) {
    const auto& lower = findings.friction->bracket.lower;
    if (!lower || findings.friction->not_in_equilibrium || lower->value == 0) return {};
    return {{lower->value, dead_alone, Side::less_friction}};
  }
  if (findings.points.size() != 1 || options.points.size() != 1 || options.parameters.total)
    return {};
  const double mu = findings.points.front().mu;
  const auto& found = findings.points.front().factors;
  if (found.any_by_supports || found.any_by_wedging || found.not_in_equilibrium) return {};
  const bool dead = loaded.has_dead;  // clearances do no work
  if (found.intervals.empty()) {
    if (!dead || found.unresolved) return {};
    return {{mu, dead_alone, Side::alone}};
  }
  std::vector<wedged::ExcludedLoad> all;
  const auto add = [&](double end, double out, Side side) {
    if (std::isinf(end) || std::isinf(out)) return;
    const double along = side == Side::less ? -1 : 1;
    all.push_back({mu, dead ? wedged::LoadShare{1, out} : wedged::LoadShare{0, along}, side});
  };
  const auto& first = found.intervals.front();
  const auto& last = found.intervals.back();
  add(first.low, first.low_out.value, Side::less);
  add(last.high, last.high_out.value, Side::more);
  return all;
}

ordered_json hold_json(const HoldOptions& options, const problems::Structure& structure,
                       const wedged::LoadedProblem& loaded, const HoldFindings& findings) {
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
  if (!findings.exclusions.empty())
    result["excluding_motions"] = exclusions_json(loaded, structure, findings.exclusions);
  return result;
}

namespace {

std::string interval_head(const std::string& first) {
  return fmt::format("\n{}  {:>18}  {:>18}  {:<15}  {}\n", first, "held from", "held to",
                     "standing", "in contact at an end");
}

// One row for each interval. @param first cell of a row, by its number
std::string interval_rows(const wedged::LoadedProblem& loaded, const HeldPoint& point,
                          const answer::HoldingFactors& answer,
                          const std::function<std::string(std::size_t)>& first) {
  std::string text;
  for (std::size_t i = 0; i < answer.intervals.size(); ++i) {
    const auto& each = point.factors.intervals[i];
    const auto shown = ends_text(each);
    fmt::format_to(std::back_inserter(text), "{}  {:>18}  {:>18}  {:<15}  {}\n", first(i + 1),
                   shown.low, shown.high, answer::name_of(answer.intervals[i].standing),
                   contact_of(loaded, each.block, each.pattern));
  }
  return text;
}

// The state in which the dead load is held; nothing if it is not.
std::string dead_load_lines(const wedged::LoadedProblem& loaded, const HeldPoint& point,
                            const answer::HoldingFactors& answer) {
  std::string text;
  for (const auto& each : point.factors.intervals) {
    text += fmt::format("\nin contact: {}\n", contact_of(loaded, each.block, each.pattern));
    text += reactions_text(loaded, each.block, each.pattern, each.state, under_factor(0, 0, 0));
  }
  if (answer.grip) text += answer::grip_line(*answer.grip);
  return text;
}

std::string point_table(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                        const HoldFindings& findings) {
  const auto& point = findings.points.front();
  const auto answer = factors_of(options, loaded, findings, 0);
  if (!answer.of_reference) return dead_load_lines(loaded, point, answer);
  auto text = interval_head(fmt::format("{:>5}", "")) +
              interval_rows(loaded, point, answer,
                            [](std::size_t number) { return fmt::format("{:>5}", number); });
  for (const auto& each : point.factors.intervals) {
    if (!each.state) continue;
    text += reactions_text(loaded, each.block, each.pattern, each.state,
                           under_factor(each.state->factor, each.low, each.high));
  }
  text += fmt::format("(factors of the reference load at {})\n",
                      friction_text(loaded.problem, point.mu));
  if (answer.grip) text += answer::grip_line(*answer.grip);
  return text;
}

// One row for each interval, and one for a coefficient without any.
std::string points_table(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                         const HoldFindings& findings) {
  auto text = interval_head(fmt::format("{:>8}", "mu"));
  std::string grips;
  for (std::size_t k = 0; k < findings.points.size(); ++k) {
    const auto& point = findings.points[k];
    const auto mu = fmt::format("{:>8}", point.mu);
    const auto answer = factors_of(options, loaded, findings, k);
    text += interval_rows(loaded, point, answer, [&](std::size_t /*number*/) { return mu; });
    if (answer.intervals.empty())
      text += fmt::format("{}  {:>18}  {:>18}  {}\n", mu, "-", "-",
                          answer::none_standing_words(answer.outside));
    if (answer.grip)
      grips += fmt::format("at {}: {}", friction_text(loaded.problem, point.mu),
                           answer::grip_line(*answer.grip));
  }
  return text +
         fmt::format("(factors of the reference load at {})\n",
                     answer::friction_words("mu", !problems::uniform_friction(loaded.problem))) +
         grips;
}

std::string bound_text(const std::optional<support::Bound>& bound, bool upper) {
  if (!bound) return "-";
  return upper ? support::rounded_up(bound->value, support::digits_of_table)
               : support::rounded_down(bound->value, support::digits_of_table);
}

// One row for each load case, or for each of its intervals.
std::string cases_table(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                        const HoldFindings& findings) {
  std::size_t width = std::string_view("load case").size();
  for (const auto& each : findings.cases) width = std::max(width, each.load_case.size());
  std::string text;
  const auto out = std::back_inserter(text);
  const auto first = [&](const std::string& name) { return fmt::format("{:<{}}", name, width); };
  if (findings.friction) {
    fmt::format_to(out, "\n{}  {:>18}  {:>18}  {}\n", first("load case"), "cannot be held at",
                   "can be held at", "in contact");
    for (const auto& each : findings.cases) {
      const auto& own = *each.friction;
      fmt::format_to(
          out, "{}  {:>18}  {:>18}  {}\n", first(each.load_case),
          bound_text(own.bracket.lower, false), bound_text(own.bracket.upper, true),
          own.any_by_supports ? "held by supports" : contact_of(loaded, own.block, own.pattern));
    }
    return text;
  }
  const bool several = options.points.size() > 1;
  const auto head = first("load case") + (several ? fmt::format("  {:>8}", "mu") : "");
  text = findings.of_reference
             ? interval_head(head)
             : fmt::format("\n{}  {:<9}  {:<15}  in contact\n", head, "dead load", "standing");
  for (const auto& each : findings.cases) {
    for (std::size_t k = 0; k < each.points.size(); ++k) {
      const auto name =
          first(each.load_case) + (several ? fmt::format("  {:>8}", options.points[k]) : "");
      const auto answer = factors_of(options, loaded, each, k);
      if (findings.of_reference) {
        text += interval_rows(loaded, each.points[k], answer, [&](std::size_t) { return name; });
        if (answer.intervals.empty())
          fmt::format_to(out, "{}  {:>18}  {:>18}  {}\n", name, "-", "-",
                         answer::none_standing_words(answer.outside));
      } else if (answer.intervals.empty()) {
        fmt::format_to(out, "{}  {:<9}  {:<15}  -\n", name, answer.open ? "not known" : "not held",
                       answer.outside ? answer::standing_word(*answer.outside) : "-");
      } else {
        const auto& held = each.points[k].factors.intervals.front();
        fmt::format_to(out, "{}  {:<9}  {:<15}  {}\n", name, "held",
                       answer::name_of(answer.intervals.front().standing),
                       contact_of(loaded, held.block, held.pattern));
      }
    }
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
    const auto answer = bracket_of(loaded, findings);
    if (found.bracket.upper || answer.reason == answer::HoldReason::searched)
      text += '\n' + answer::bracket_line(answer);
    if (found.bracket.upper) {
      fmt::format_to(out, "in contact: {}\n", contact_of(loaded, found.block, found.pattern));
      text +=
          reactions_text(loaded, found.block, found.pattern, found.state, under_factor(0, 0, 0));
    }
  } else if (findings.diagram) {
    text += diagram_table(loaded, options.cases, *findings.diagram);
  } else if (options.points.size() > 1 && !findings.points.empty()) {
    text += points_table(options, loaded, findings);
  } else if (!findings.points.empty()) {
    text += point_table(options, loaded, findings);
  }
  if (!findings.cases.empty()) text += cases_table(options, loaded, findings);
  std::uint64_t opened = 0;
  for (const auto& cost : findings.costs()) opened += cost.opened;
  fmt::format_to(out, "\n{}, {}\n", answer::counted(findings.costs().size(), "tree"),
                 answer::counted(opened, "node"));
  return text;
}

}  // namespace kusabi::run
