// Load cases, one row each.
#include "run/limit/limit_cases.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

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

// Existence of carried factors in a case, which cases are compared by first.
enum class Carried {
  none,
  none_after_a_loss,
  none_at_residual,
  none_at_residual_after_a_loss,
  some
};

/// Rank of a case, the least first; infinity: the factor is unknown.
using Rank = std::pair<Carried, double>;

// At one strength. A search that was stopped before it found an upper bound leaves that of the
// nominal load without any loss.
Rank rank_at_strength(const limit::LimitAnswer& answer,
                      const std::optional<limit::LossAnswer>& loss, bool residual) {
  if (limit::at_no_factor(answer)) return {residual ? Carried::none_at_residual : Carried::none, 0};
  if (loss && loss->fatal)
    return {residual ? Carried::none_at_residual_after_a_loss : Carried::none_after_a_loss, 0};
  const auto upper = loss           ? loss->ends.upper
                     : answer.worst ? answer.worst->ends.upper
                                    : std::nullopt;
  if (upper) return {Carried::some, upper->value};
  return {Carried::some,
          answer.nominal ? answer.nominal->factor : std::numeric_limits<double>::infinity()};
}

Rank rank(const LimitCase& each) {
  const auto& found = each.found;
  const auto full = rank_at_strength(found.answer, found.loss, false);
  return found.residual
             ? std::min(full, rank_at_strength(*found.residual, found.residual_loss, true))
             : full;
}

const char* state_of(const limit::LimitFindings& found) {
  if (!found.whole()) return "open";
  return limit::at_no_factor(found.answer) ? "not-carried" : "solved";
}

// The results of one case at one strength in a line, and the critical combination of its actions in
// another. @param indent of the latter
std::string found_text(const LimitCase& each, const limit::LimitAnswer& answer,
                       const std::optional<limit::LossAnswer>& loss, bool with_losses,
                       const char* indent) {
  if (auto none = at_none_text(each.truss, answer)) return *none;
  if (!answer.nominal) return "open";
  std::vector<std::string> parts;
  if (!has_ranges(each.truss))
    parts.push_back("nominal " + factor_text(answer.nominal_factors.largest));
  if (answer.worst) parts.push_back("worst case " + factor_text(answer.worst->ends));
  if (!with_losses && !answer.whole()) parts.emplace_back("open");
  if (with_losses) {
    parts.push_back("after a loss " + (loss && loss->fatal
                                           ? at_none_text(each.truss, loss->uncertain, *loss->fatal)
                                           : factor_text(loss ? loss->ends : support::Bracket{})));
  }
  auto text = fmt::format("{}", fmt::join(parts, ", "));
  if (with_losses) return text;
  const auto combination = combination_text(each.truss, each.problem,
                                            answer.worst ? answer.worst->zeta : Eigen::VectorXd());
  return combination.empty() ? text : fmt::format("{}\n{}{}", text, indent, combination);
}

}  // namespace

const LimitCase& governing(std::span<const LimitCase> cases) {
  return *std::ranges::min_element(cases, {}, rank);
}

bool all_whole(std::span<const LimitCase> cases) {
  return std::ranges::all_of(cases, [](const auto& each) { return each.found.whole(); });
}

bool has_ranges(const problems::Structure& truss) {
  return std::ranges::any_of(
      truss.actions, [](const auto& each) { return !each.reference && each.lower != each.upper; });
}

bool of_all_loads(std::span<const LimitCase> cases, const limit::LimitParameters& parameters) {
  const auto has = [&](auto what) { return std::ranges::any_of(cases, what); };
  if (has([](const auto& each) { return each.found.answer.worst.has_value(); })) return true;
  return parameters.alpha && !parameters.loss &&
         !has([](const auto& each) { return limit::at_no_factor(each.found.answer).has_value(); });
}

bool with_struts(std::span<const LimitCase> cases) {
  return std::ranges::any_of(cases,
                             [](const auto& each) { return each.found.residual.has_value(); });
}

namespace {

bool is_claimed(const std::optional<limit::LossAnswer>& loss) {
  return loss && loss->theorem && loss->proved();
}

}  // namespace

bool have_theorems(std::span<const LimitCase> cases, bool of_losses) {
  return std::ranges::all_of(cases, [&](const auto& each) {
    return of_losses ? is_claimed(each.found.loss) : !each.found.theorems.empty();
  });
}

std::vector<verify::TrussTheorem> all_theorems(std::span<const LimitCase> cases, bool of_losses) {
  const bool residual = std::ranges::all_of(
      cases, [](const auto& each) { return is_claimed(each.found.residual_loss); });
  std::vector<verify::TrussTheorem> all;
  const auto add = [&](const LimitCase& from, const verify::TrussTheorem& theorem) {
    all.push_back(theorem);
    all.back().load_case = from.name;
  };
  for (const auto& each : cases) {
    if (!of_losses) {
      for (const auto& theorem : each.found.theorems) add(each, theorem);
      continue;
    }
    add(each, *each.found.loss->theorem);
    if (residual) add(each, *each.found.residual_loss->theorem);
  }
  return all;
}

limit::GuaranteedInterval interval_of_all(std::span<const LimitCase> cases, bool all_loads) {
  std::vector<limit::GuaranteedInterval> intervals;
  intervals.reserve(cases.size());
  for (const auto& each : cases) {
    const auto& [answer, residual] = std::tie(each.found.answer, each.found.residual);
    intervals.push_back(all_loads ? guaranteed_interval(answer, residual)
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

const char* load_without_factor(const problems::Structure& truss, bool uncertain) {
  if (!uncertain) return "the dead load";
  return truss.actions.empty() ? "some admissible dead load" : "some combination of actions";
}

std::string at_none_text(const problems::Structure& truss, bool uncertain,
                         support::Standing standing) {
  return fmt::format("{} is carried at no load factor of either sign, {}",
                     load_without_factor(truss, uncertain), answer::standing_word(standing));
}

std::optional<std::string> at_none_text(const problems::Structure& truss,
                                        const limit::LimitAnswer& answer) {
  const auto standing = limit::at_no_factor(answer);
  if (!standing) return {};
  return at_none_text(truss, answer.worst || has_ranges(truss), *standing);
}

std::string cases_text(std::span<const LimitCase> cases, const limit::LimitParameters& parameters) {
  std::string text = fmt::format(
      "{} load cases{}\n", cases.size(),
      with_struts(cases) ? ", all struts at their strength, an upper value, and then at "
                           "their residual strength"
                         : "");
  const auto out = std::back_inserter(text);
  const bool with_losses = parameters.loss.has_value();
  for (const auto& each : cases) {
    const auto& found = each.found;
    fmt::format_to(out, "  {}: {}\n", each.name,
                   found_text(each, found.answer, found.loss, with_losses, "    "));
    if (found.residual)
      fmt::format_to(out, "    at residual strength: {}\n",
                     found_text(each, *found.residual, found.residual_loss, with_losses, "      "));
  }
  if (!with_losses) {
    const bool all_loads = of_all_loads(cases, parameters);
    const auto interval = interval_of_all(cases, all_loads);
    const auto loads = loads_text(cases, all_loads ? parameters.alpha : std::nullopt);
    fmt::format_to(out, "in all cases: {}\n", interval_text(interval, loads));
    if (all_loads) fmt::format_to(out, "  {}\n", passed_text(interval));
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
    if (const auto& loss = each.found.loss) {
      const auto& carried = each.found.residual ? each.found.residual_loss : loss;
      row["factor"] = answer::written(
          support::Bracket{carried ? carried->ends.lower : std::nullopt, loss->ends.upper});
      const auto fatal = loss->fatal || !carried ? loss->fatal : carried->fatal;
      if (fatal) row["fatal"] = answer::name_of(*fatal);
    }
    row["state"] = state_of(each.found);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace kusabi::run
