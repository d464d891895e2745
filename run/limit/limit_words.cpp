// Sentences about members and loads, and lists of names with values.
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

#include "answer/answer_words.hpp"
#include "answer/values.hpp"
#include "problems/limit/action_factors.hpp"
#include "problems/limit/collapse_mode.hpp"
#include "problems/limit/half_widths.hpp"
#include "problems/limit/utilisation.hpp"
#include "run/limit/limit_report.hpp"
#include "run/output/name_ranges.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using limit::LimitCollapse;
using problems::LimitProblem;

/// Displayed as 100.0 %.
constexpr double in_full = 0.9995;
/// Maximum number of members listed after those that yield.
constexpr std::size_t max_named = 5;
/// Maximum number of names in a sentence; the lines above list all.
constexpr std::size_t max_in_sentence = 8;

std::string size_text(double size, const std::string& unit) {
  return fmt::format("{:.6g} {}", size, unit.empty() ? "in the file's unit of force" : unit);
}

// The nodes on which a load acts: "at p q t".
std::string nodes_of(const LimitProblem& problem, const problems::UncertainColumn& column) {
  std::vector<int> nodes;
  for (const auto& each : column.direction) {
    const int node = problem.degrees.free[static_cast<std::size_t>(each.degree)].node;
    if (std::ranges::find(nodes, node) == nodes.end()) nodes.push_back(node);
  }
  std::vector<std::string> names;
  for (const int node : nodes) {
    if (names.size() == max_in_sentence) break;
    names.push_back(problem.node_names[static_cast<std::size_t>(node)]);
  }
  const auto more = nodes.size() - names.size();
  return fmt::format("at {}{}", fmt::join(names, " "),
                     more > 0 ? fmt::format(" and {} more", more) : std::string());
}

// "4 members yield: a-b b-c c-d d-e."
// @param lost members that are not there
std::string yielding_sentence(const LimitProblem& problem, const LimitCollapse& collapse,
                              const char* when, std::span<const int> lost) {
  const auto mode = problems::collapse_mode(problem, collapse.motion);
  std::vector<std::string> names;
  for (const auto& each : mode.yielding) {
    if (std::ranges::find(lost, each.member) == lost.end())
      names.push_back(problems::member_name(problem, each.member));
  }
  const auto all = names.size();
  if (all == 0) return {};
  if (all > max_in_sentence) {
    names.resize(max_in_sentence);
    names.push_back(fmt::format("and {} more", all - max_in_sentence));
  }
  return fmt::format("{} {} {}: {}.", when, answer::counted(all, "member"),
                     all == 1 ? "yields" : "yield", fmt::join(names, " "));
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
  std::string text = "  utilisation of other members:";
  const auto full = static_cast<std::size_t>(
      std::ranges::count_if(others, [&](int i) { return used(i) >= in_full; }));
  if (full > 0) {
    const auto named = std::min(full, max_named);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < named; ++i)
      names.push_back(problems::member_name(problem, others[i]));
    text += fmt::format(" {} at 100 % ({}{}),", full, fmt::join(names, " "),
                        named < full ? " and others" : "");
  }
  others.erase(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(full));
  const auto all = others.size();
  others.resize(std::min(all, max_named));
  for (const int i : others)
    text += fmt::format(" {} {:.1f} %,", problems::member_name(problem, i), 100 * used(i));
  text.pop_back();
  if (all <= max_named) return text + '\n';
  return text + (all == max_named + 1 ? "; one other has less\n"
                                      : fmt::format("; {} others have less\n", all - max_named));
}

std::string combination_text(const problems::Structure& truss, const LimitProblem& problem,
                             const Eigen::VectorXd& zeta) {
  if (zeta.size() != problem.uncertain_count()) return {};
  std::vector<std::string> fixed;
  std::vector<std::string> multiplied;
  for (const auto& [action, factor, reference] : problems::action_factors(truss, problem, zeta))
    (reference ? multiplied : fixed).push_back(fmt::format("{:.6g} {}", factor, action));
  if (multiplied.empty()) return {};
  return fmt::format("{}{}{} times the load factor", fmt::join(fixed, ", "),
                     fixed.empty() ? "" : "; ", fmt::join(multiplied, ", "));
}

std::string critical_load_text(const problems::Structure& truss, const LimitProblem& problem,
                               const Eigen::VectorXd& zeta) {
  if (zeta.size() != problem.uncertain_count()) return {};
  if (const auto text = combination_text(truss, problem, zeta); !text.empty()) {
    const bool corner = (zeta.array().abs() == 1).all();
    return fmt::format("  critical {}: {}\n",
                       corner ? "combination" : "factors, within their ranges", text);
  }
  const auto& unit = problem.units.force;
  if (zeta.isZero(0.0)) return {};
  std::string text = "  critical part of the dead load:\n";
  // Key: axis, + before -, value as displayed.
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
    text += fmt::format("    {}{} ({}): {:.6g} times\n", zeta(j) >= 0 ? '+' : '-', column.name,
                        nodes_of(problem, column), std::abs(zeta(j)) * column.half_width);
  }
  return text;
}

namespace {

// Bounds of the uncertain loads in all cases.
answer::LoadRange load_range(const LimitOptions& options, std::span<const LimitCase> cases) {
  answer::LoadRange loads;
  std::set<std::pair<std::optional<double>, std::optional<std::string_view>>> half_widths;
  for (const auto& each : cases)
    half_widths.emplace(problems::common_half_width(each.problem, *options.parameters.alpha),
                        unit_of_alpha(each.problem));
  if (half_widths.size() > 1) return loads;
  const auto& [half_width, unit] = *half_widths.begin();
  loads.half_width = half_width;
  if (unit) loads.force = std::string(*unit);
  return loads;
}

// The action that the load factor multiplies, if the load cases are combinations, and its factor, if
// that is the same in all of them.
void set_reference(std::span<const LimitCase> cases, answer::LoadInterval& interval) {
  std::set<double> factors;
  for (const auto& each : cases) {
    for (const auto& range : each.truss->actions) {
      if (!range.reference) continue;
      interval.reference_action = range.action;
      factors.insert(range.upper);
    }
  }
  if (factors.size() == 1) interval.reference_factor = *factors.begin();
}

// Load factors of one case, as of all of them.
limit::GuaranteedInterval interval_of(const LimitCase& each, bool all_loads) {
  return all_loads ? guaranteed_interval(each.found.answer, each.found.residual)
                   : nominal_interval(each.found.answer, each.found.residual);
}

// The load cases of which a statement holds.
template <class Holds>
std::string cases_named(std::span<const LimitCase> cases, Holds holds) {
  std::vector<std::string> names;
  for (const auto& each : cases) {
    if (holds(each)) names.push_back(each.name);
  }
  if (names.empty()) return {};
  return names.size() == 1 ? fmt::format("That is so in load case {}.", names.front())
                           : fmt::format("That is so in load cases {}.", fmt::join(names, ", "));
}

// The critical combination of the actions of a case, with struts at their residual strength.
std::string critical_combination(const LimitCase& each) {
  const auto& answer = each.found.residual ? *each.found.residual : each.found.answer;
  return combination_text(each.truss, each.problem,
                          answer.worst ? answer.worst->zeta : Eigen::VectorXd());
}

// The load cases in which the carried factors of all cases begin and end.
std::string cases_at_ends(std::span<const LimitCase> cases, const answer::LoadInterval& interval,
                          bool all_loads) {
  if (cases.size() < 2) {
    const auto combination = critical_combination(cases.front());
    if (combination.empty() || interval.carried_at_none) return {};
    return fmt::format("Critical combination{}: {}.", all_whole(cases) ? "" : " known",
                       combination);
  }
  if (interval.carried_at_none) {
    return cases_named(
        cases, [&](const auto& each) { return interval_of(each, all_loads).at_none.has_value(); });
  }
  const auto& [from, to] = std::tie(interval.minimum, interval.maximum);
  if (!from.lower || !to.upper) return {};
  const auto lower = [&](const auto& each) {
    return interval_of(each, all_loads).minimum.at_least();
  };
  const auto upper = [&](const auto& each) {
    return interval_of(each, all_loads).largest.at_most();
  };
  if (from.lower->value > to.upper->value) {
    const auto& begins = *std::ranges::max_element(cases, {}, lower);
    const auto& ends = *std::ranges::min_element(cases, {}, upper);
    if (&begins == &ends) {
      return fmt::format(
          "In load case {} a load is carried only from {} on{}, and another one only "
          "up to {}{}.",
          begins.name, support::rounded_down(from.lower->value),
          answer::unless_proved(from.lower->standing), support::rounded_up(to.upper->value),
          answer::unless_proved(to.upper->standing));
    }
    return fmt::format(
        "Load case {} is carried only from {} on{}, load case {} only up to {}{}.", begins.name,
        support::rounded_down(from.lower->value), answer::unless_proved(from.lower->standing),
        ends.name, support::rounded_up(to.upper->value), answer::unless_proved(to.upper->standing));
  }
  if (interval.struts && !to.lower) return {};
  const auto& governs = governing(cases);
  const auto combination = critical_combination(governs);
  return fmt::format("The least {}of the largest factors is that of load case {}{}{}{}.",
                     all_whole(cases) ? "" : "known ", governs.name,
                     interval.struts ? ", at residual strength" : "",
                     combination.empty() ? "" : ": ", combination);
}

answer::LoadInterval load_interval(const LimitOptions& options, std::span<const LimitCase> cases,
                                   bool all_loads) {
  const auto found = interval_of_all(cases, all_loads);
  answer::LoadInterval interval{.cases = cases.size(), .struts = with_struts(cases)};
  if (all_loads) interval.uncertain = load_range(options, cases);
  set_reference(cases, interval);
  interval.carried_at_none = found.at_none;
  if (found.at_none) return interval;
  interval.minimum = found.minimum;
  interval.maximum = found.largest;
  interval.if_big_m = std::ranges::any_of(cases, [](const auto& each) {
    const auto& worst = each.found.answer.worst;
    return worst && worst->as_printed && !worst->proved();
  });
  return interval;
}

}  // namespace

answer::Verdict limit_verdict(const LimitOptions& options, std::span<const LimitCase> cases) {
  const auto& governs = governing(cases);
  const auto& answer = governs.found.answer;
  answer::Verdict verdict;
  for (const auto& each : cases) {
    if (verdict.ended == engine::Status::solved) verdict.ended = each.found.ended();
  }
  const bool struts = with_struts(cases);
  const auto yields = [&](const LimitCollapse& collapse, const char* when,
                          std::span<const int> lost = {}) {
    if (struts) when = "At full strength";
    if (auto text = yielding_sentence(governs.problem, collapse, when, lost); !text.empty())
      verdict.details.push_back(std::move(text));
  };
  const bool all_loads = of_all_loads(cases, options.parameters);
  auto interval = load_interval(options, cases, all_loads);
  if (answer.worst) {
    const auto& worst = *answer.worst;
    if (worst.collapse && worst.status != limit::RootStatus::not_carried)
      yields(*worst.collapse, worst.proved() ? "In the worst case" : "Under the worst load known");
  } else if (answer.nominal) {
    yields(*answer.nominal, all_loads          ? "Under the nominal load"
                            : cases.size() < 2 ? "Then"
                            : all_whole(cases) ? "At the least of the largest factors"
                                               : "At the least known of the largest factors");
  }
  interval.incomplete = !all_whole(cases);
  if (auto text = cases_at_ends(cases, interval, all_loads);
      !text.empty() && (!options.parameters.loss || interval.carried_at_none))
    verdict.details.insert(verdict.details.begin(), std::move(text));
  verdict.answer = interval;
  if (options.parameters.loss && !interval.carried_at_none) {
    verdict.details.clear();
    auto of_loss = member_loss(cases, options.parameters);
    const auto& loss = governs.found.loss;
    if (cases.size() > 1 && of_loss.fatal) {
      verdict.details.push_back(cases_named(cases, [](const auto& each) {
        return each.found.loss && each.found.loss->fatal.has_value();
      }));
    } else if (cases.size() > 1 && of_loss.factor.upper && (!loss || !loss->lost.empty())) {
      verdict.details.push_back(fmt::format("The least factor {}is that of load case {}.",
                                            all_whole(cases) ? "" : "known ", governs.name));
    }
    if (loss && loss->collapse) yields(*loss->collapse, "Then", loss->lost);
    verdict.answer = std::move(of_loss);
  }
  if (auto text = strut_sentence(cases); !text.empty()) verdict.details.push_back(std::move(text));
  return verdict;
}

}  // namespace kusabi::run
