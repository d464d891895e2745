// Sentences and lists of names, with their sizes.
#include "run/limit/limit_words.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/limit/collapse_mode.hpp"
#include "problems/limit/half_widths.hpp"
#include "problems/limit/utilisation.hpp"
#include "run/output/name_ranges.hpp"
#include "run/output/values.hpp"

namespace kusabi::run {
namespace {

using limit::LimitAnswer;
using limit::LimitCollapse;
using problems::LimitProblem;

/// Shown as 100.0 %.
constexpr double in_full = 0.9995;
/// So many members are said to be the next.
constexpr std::size_t most_named = 5;
/// In a sentence; the lines above name all.
constexpr std::size_t most_in_sentence = 8;

std::string size_text(double size, const std::string& unit) {
  return fmt::format("{:.6g} {}", size, unit.empty() ? "in the file's unit of force" : unit);
}

// "4 members yield: a-b b-c c-d d-e."
std::string yielding_sentence(const LimitProblem& problem, const LimitCollapse& collapse,
                              const char* when) {
  const auto mode = problems::collapse_mode(problem, collapse.motion);
  std::vector<std::string> names;
  for (const auto& each : mode.yielding)
    names.push_back(problems::member_name(problem, each.member));
  const auto all = names.size();
  if (all == 0) return {};
  if (all > most_in_sentence) {
    names.resize(most_in_sentence);
    names.push_back(fmt::format("and {} more", all - most_in_sentence));
  }
  return fmt::format("{} {} {}: {}.", when, counted(all, "member"), all == 1 ? "yields" : "yield",
                     fmt::join(names, " "));
}

}  // namespace

std::optional<std::string_view> unit_of_alpha(const LimitProblem& problem) {
  if (!problems::alpha_is_force(problem)) return std::nullopt;
  return problem.units.force;
}

std::string utilisation_text(const LimitProblem& problem, const LimitCollapse& collapse) {
  const auto used = problems::utilisation(problem, collapse.forces);
  std::set<int> yielding;
  for (const auto& each : problems::collapse_mode(problem, collapse.motion).yielding)
    yielding.insert(each.member);
  std::vector<int> others;
  for (int i = 0; i < static_cast<int>(used.size()); ++i) {
    if (!yielding.contains(i) && used(i) > 0) others.push_back(i);
  }
  if (others.empty()) return {};
  std::ranges::stable_sort(others, std::greater(), [&](int i) { return used(i); });
  std::string text = "  utilisation of the others:";
  const auto full = static_cast<std::size_t>(
      std::ranges::count_if(others, [&](int i) { return used(i) >= in_full; }));
  if (full > 0) text += fmt::format(" {} at 100 %,", full);
  others.erase(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(full));
  const auto all = others.size();
  others.resize(std::min(all, most_named));
  for (const int i : others)
    text += fmt::format(" {} {:.1f} %,", problems::member_name(problem, i), 100 * used(i));
  text.pop_back();
  return text + (all > most_named ? fmt::format("; {} less\n", all - most_named) : "\n");
}

std::string critical_load_text(const LimitProblem& problem, const Eigen::VectorXd& zeta) {
  if (zeta.size() != problem.uncertain_count()) return {};
  const auto& unit = problem.units.force;
  std::string text = "  critical part of the dead load:\n";
  // Axis, then + before -, then the size as it is shown.
  std::map<std::tuple<int, bool, std::string>, std::vector<std::string>> places;
  for (int j = 0; j < problem.uncertain_count(); ++j) {
    const auto& column = problem.uncertain[static_cast<std::size_t>(j)];
    if (!column.name.empty()) continue;
    const auto& free =
        problem.degrees.free[static_cast<std::size_t>(column.direction.front().degree)];
    const auto size = size_text(std::abs(zeta(j)) * column.largest(), unit);
    places[{free.axis, zeta(j) < 0, size}].push_back(
        problem.node_names[static_cast<std::size_t>(free.node)]);
  }
  for (const auto& [what, names] : places) {
    const auto& [axis, negative, size] = what;
    text += fmt::format("    {}{} at {}: {}{}\n", negative ? '-' : '+', problems::axis_name(axis),
                        fmt::join(names, " "), size, names.size() == 1 ? "" : " each");
  }
  for (int j = 0; j < problem.uncertain_count(); ++j) {
    const auto& column = problem.uncertain[static_cast<std::size_t>(j)];
    if (column.name.empty()) continue;
    text += fmt::format("    {}{}: {:.6g} times\n", zeta(j) >= 0 ? '+' : '-', column.name,
                        std::abs(zeta(j)) * column.half_width);
  }
  return text;
}

Verdict limit_verdict(const LimitOptions& options, std::span<const LimitCase> cases) {
  const auto& [name, truss, problem, found] = governing(cases);
  const auto& answer = found.answer;
  const auto& worst = answer.worst;
  Verdict verdict;
  for (const auto& each : cases) {
    const auto& its = each.found.answer;
    const auto stopped =
        its.worst && its.worst->search != engine::Status::solved ? its.worst->search : its.rest;
    if (verdict.ended == engine::Status::solved) verdict.ended = stopped;
  }
  LoadInterval interval;
  const auto standing = [](bool proved) { return proved ? Standing::proved : Standing::computed; };
  const auto yields = [&](const LimitCollapse& collapse, const char* when) {
    if (auto text = yielding_sentence(problem, collapse, when); !text.empty())
      verdict.details.push_back(std::move(text));
  };
  if (worst) {
    interval.uncertain.emplace();
    interval.uncertain->half_width =
        problems::common_half_width(problem, options.question.alpha.value_or(0));
    if (const auto unit = unit_of_alpha(problem)) interval.uncertain->force = std::string(*unit);
    if (worst->status == limit::RootStatus::not_carried) {
      interval.carried_at_none = standing(worst->proved);
    } else {
      const auto& ends = worst->ends;
      if (std::isfinite(ends.lower))
        interval.most.lower = Bound{ends.lower, standing(ends.lower_proved)};
      if (std::isfinite(ends.upper))
        interval.most.upper = Bound{ends.upper, standing(ends.upper_proved)};
      interval.if_big_m = worst->as_printed && !worst->proved;
      if (worst->collapse)
        yields(*worst->collapse, worst->proved ? "In the worst case" : "At the worst known");
    }
  } else if (answer.nominal) {
    interval.most.lower = Bound{answer.nominal->factor, Standing::computed};
    interval.most.upper = interval.most.lower;
    yields(*answer.nominal, "Then");
  } else if (answer.status == limit::LoadStatus::not_carried) {
    interval.carried_at_none = standing(answer.no_factor_proved);
  }
  interval.incomplete = !all_whole(cases);
  verdict.answer = interval;
  return verdict;
}

}  // namespace kusabi::run
