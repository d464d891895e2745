// Load cases, one row each.
#include "run/limit/limit_cases.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/fields.hpp"
#include "answer/values.hpp"
#include "answer/words.hpp"
#include "run/limit/limit_report.hpp"
#include "run/pictures/limit_values.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

// Factor by which cases are compared; infinity: unknown.
double min_factor(const LimitCase& each) {
  const auto& answer = each.found.answer;
  constexpr double none = -std::numeric_limits<double>::infinity();
  if (const auto& loss = each.found.loss) return loss->fatal ? none : loss->ends.at_most();
  if (limit::at_no_factor(answer)) return none;
  if (answer.worst) return answer.worst->ends.at_most();
  return answer.nominal ? answer.nominal->factor : std::numeric_limits<double>::infinity();
}

const char* state_of(const limit::LimitFindings& found) {
  if (!found.whole()) return "open";
  return limit::at_no_factor(found.answer) ? "not-carried" : "solved";
}

// The results of one case in a line, and the critical combination of its actions in another.
std::string found_text(const LimitCase& each) {
  const auto& found = each.found;
  const auto& answer = found.answer;
  if (const auto standing = limit::at_no_factor(answer))
    return fmt::format("not carried at any factor, {}", answer::standing_word(*standing));
  if (!answer.nominal) return "open";
  std::vector<std::string> parts;
  if (!has_ranges(each.truss))
    parts.push_back("nominal " + factor_text(answer.nominal_factors.largest));
  if (answer.worst) parts.push_back("worst case " + factor_text(answer.worst->ends));
  if (!found.loss && !answer.whole()) parts.emplace_back("open");
  if (const auto& loss = found.loss) {
    parts.push_back(
        loss->fatal ? fmt::format("no factor after a loss, {}", answer::standing_word(*loss->fatal))
                    : "after a loss " + factor_text(loss->ends));
  }
  auto text = fmt::format("{}", fmt::join(parts, ", "));
  if (each.found.loss) return text;
  const auto combination = combination_text(each.truss, each.problem,
                                            answer.worst ? answer.worst->zeta : Eigen::VectorXd());
  return combination.empty() ? text : fmt::format("{}\n    {}", text, combination);
}

}  // namespace

const LimitCase& governing(std::span<const LimitCase> cases) {
  return *std::ranges::min_element(cases, {}, min_factor);
}

bool all_whole(std::span<const LimitCase> cases) {
  return std::ranges::all_of(cases, [](const auto& each) { return each.found.whole(); });
}

bool has_ranges(const problems::Structure& truss) {
  return std::ranges::any_of(
      truss.actions, [](const auto& each) { return !each.reference && each.lower != each.upper; });
}

bool with_worst_case(std::span<const LimitCase> cases) {
  return std::ranges::any_of(cases,
                             [](const auto& each) { return each.found.answer.worst.has_value(); });
}

bool with_struts(std::span<const LimitCase> cases) {
  return std::ranges::any_of(cases,
                             [](const auto& each) { return each.found.residual.has_value(); });
}

bool have_statements(std::span<const LimitCase> cases) {
  return std::ranges::none_of(cases,
                              [](const auto& each) { return each.found.statements.empty(); });
}

std::vector<verify::LimitStatement> all_statements(std::span<const LimitCase> cases) {
  std::vector<verify::LimitStatement> all;
  for (const auto& each : cases) {
    for (const auto& statement : each.found.statements) {
      all.push_back(statement);
      all.back().load_case = each.name;
    }
  }
  return all;
}

namespace {

bool is_claimed(const std::optional<limit::LossAnswer>& loss) {
  return loss && loss->statement && loss->proved();
}

}  // namespace

bool have_loss_statements(std::span<const LimitCase> cases) {
  return std::ranges::all_of(cases, [](const auto& each) { return is_claimed(each.found.loss); });
}

std::vector<verify::LossStatement> all_loss_statements(std::span<const LimitCase> cases) {
  const bool residual = std::ranges::all_of(
      cases, [](const auto& each) { return is_claimed(each.found.residual_loss); });
  std::vector<verify::LossStatement> all;
  for (const auto& each : cases) {
    all.push_back(*each.found.loss->statement);
    all.back().load_case = each.name;
    if (!residual) continue;
    all.push_back(*each.found.residual_loss->statement);
    all.back().load_case = each.name;
    all.back().residual = true;
  }
  return all;
}

limit::GuaranteedInterval interval_of_all(std::span<const LimitCase> cases) {
  const bool worst = with_worst_case(cases);
  std::vector<limit::GuaranteedInterval> intervals;
  intervals.reserve(cases.size());
  for (const auto& each : cases) {
    const auto& [answer, residual] = std::tie(each.found.answer, each.found.residual);
    intervals.push_back(worst ? guaranteed_interval(answer, residual)
                              : nominal_interval(answer, residual));
  }
  return intersection(intervals);
}

std::string loads_text(std::span<const LimitCase> cases, std::optional<double> alpha) {
  if (!cases.front().truss->actions.empty()) {
    return cases.size() > 1 ? " in every combination of actions"
                            : " for all factors of the actions within their ranges";
  }
  const auto is_uncertain = [&](const auto& column) { return *alpha * column.half_width > 0; };
  const auto any_is_uncertain = [&](const LimitCase& each) {
    return std::ranges::any_of(each.problem.uncertain, is_uncertain);
  };
  return alpha && std::ranges::any_of(cases, any_is_uncertain) ? " under all admissible loads"
                                                               : " under the dead load";
}

std::string cases_text(std::span<const LimitCase> cases, std::optional<double> alpha) {
  std::string text =
      fmt::format("{} load cases{}\n", cases.size(), with_struts(cases) ? upper_values : "");
  const auto out = std::back_inserter(text);
  for (const auto& each : cases) fmt::format_to(out, "  {}: {}\n", each.name, found_text(each));
  const auto interval = interval_of_all(cases);
  if (!cases.front().found.loss) {
    fmt::format_to(out, "in all cases: {}\n", interval_text(interval, loads_text(cases, alpha)));
    if (with_worst_case(cases)) fmt::format_to(out, "  {}\n", passed_text(interval));
  }
  fmt::format_to(
      out, "{} {}\n\nload case {}\n",
      all_whole(cases) ? "the least factor is that of" : "the least known factor is that of",
      governing(cases).name, governing(cases).name);
  return text;
}

ordered_json cases_json(std::span<const LimitCase> cases) {
  auto rows = ordered_json::array();
  for (const auto& each : cases) {
    const auto& answer = each.found.answer;
    ordered_json row{{"name", each.name},
                     {"nominal", answer.nominal ? ordered_json(answer.nominal->factor) : nullptr}};
    if (!each.truss->actions.empty() && !each.found.loss) {
      row["critical_factors"] = factors_json(each.truss, each.problem,
                                             answer.worst ? answer.worst->zeta : Eigen::VectorXd());
    }
    if (answer.worst) row.update(interval_json(guaranteed_interval(answer, each.found.residual)));
    if (const auto& loss = each.found.loss) row["factor"] = answer::written(loss->ends);
    row["state"] = state_of(each.found);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace kusabi::run
