// Names of members, and one row for each.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/fields.hpp"
#include "answer/values.hpp"
#include "answer/words.hpp"
#include "problems/limit/collapse_mode.hpp"
#include "run/limit/limit_report.hpp"
#include "run/output/values.hpp"
#include "run/pictures/limit_values.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using limit::LoadStatus;
using limit::LossAnswer;
using limit::SingleLoss;
using nlohmann::ordered_json;
using problems::LimitProblem;

/// Smaller relative changes of a factor are rounding errors of the simplex method.
constexpr double lowers_by = 1e-9;

double value_of(const SingleLoss& single) {
  if (single.status == LoadStatus::not_carried) return -std::numeric_limits<double>::infinity();
  if (single.status == LoadStatus::undetermined) return std::numeric_limits<double>::infinity();
  return single.factor;
}

std::string singles_text(const LimitProblem& problem, const LossAnswer& loss) {
  if (loss.singles.empty()) return {};
  auto singles = loss.singles;
  std::ranges::stable_sort(singles, {}, value_of);
  const double nominal = loss.nominal;
  const auto lowers = [&](const SingleLoss& single) {
    return value_of(single) < nominal - lowers_by * std::abs(nominal);
  };
  std::string text = loss.uncertain
                         ? "  loss of one member (upper bounds, computed by alternating linear "
                           "programs):\n"
                         : "  loss of one member (computed):\n";
  const auto out = std::back_inserter(text);
  std::size_t shown = 0;
  for (const auto& single : singles) {
    if (!lowers(single)) break;
    ++shown;
    const auto name = problems::member_name(problem, single.member);
    if (single.status == LoadStatus::not_carried) {
      fmt::format_to(out, "    {}: {} is carried at no load factor\n", name,
                     loss.uncertain ? "some admissible load" : "the dead load");
    } else {
      constexpr int digits = 10;
      fmt::format_to(out, "    {}: {}\n", name,
                     loss.uncertain ? support::rounded_up(single.factor, digits)
                                    : fmt::format("{:.{}g}", single.factor, digits));
    }
  }
  const auto failed = static_cast<std::size_t>(
      std::ranges::count(singles, LoadStatus::undetermined, &SingleLoss::status));
  if (failed > 0)
    fmt::format_to(out, "    {}: the simplex method failed\n", answer::counted(failed, "member"));
  const auto missing = static_cast<std::size_t>(loss.eligible) - singles.size();
  if (missing > 0) {
    fmt::format_to(out, "    {}: not computed before the early end\n",
                   answer::counted(missing, "member"));
  }
  // A larger upper bound of the worst case does not exclude a smaller factor.
  const char* const rest = loss.uncertain ? "for {} of {} no lower factor was found"
                                          : "{} of {} do not lower the factor";
  fmt::format_to(out, "    {}\n",
                 fmt::format(fmt::runtime(rest), singles.size() - shown - failed,
                             answer::counted(singles.size(), "member")));
  return text;
}

// Remark on a loss after which one node alone moves under its load.
std::string fatal_text(const LimitProblem& problem, const problems::Structure& truss,
                       const LossAnswer& loss) {
  if (loss.fatal_motion.size() == 0) return {};
  const auto moving = problems::collapse_mode(problem, loss.fatal_motion).moving;
  if (moving.size() != 1) return {};
  const int node = moving.front().node;
  const auto height = [&](int of) { return truss.coordinates(truss.dimension - 1, of); };
  std::size_t below = 0;
  std::size_t lost_below = 0;
  std::size_t lost_there = 0;
  for (int i = 0; i < problem.member_count(); ++i) {
    const auto& bar = problem.members[static_cast<std::size_t>(i)];
    if (bar.first != node && bar.second != node) continue;
    const bool is_lost = std::ranges::find(loss.lost, i) != loss.lost.end();
    const bool is_below = height(bar.first == node ? bar.second : bar.first) < height(node);
    lost_there += is_lost ? 1 : 0;
    below += is_below ? 1 : 0;
    lost_below += is_lost && is_below ? 1 : 0;
  }
  const auto& name = problem.node_names[static_cast<std::size_t>(node)];
  if (lost_below == loss.lost.size() && lost_below == below)
    return fmt::format("  these are all members below node {}, which is loaded\n", name);
  if (lost_there == loss.lost.size())
    return fmt::format("  node {}, where these members end, cannot carry its load\n", name);
  return {};
}

void write_ends(std::string& text, const problems::Structure& truss, const LossAnswer& loss) {
  const auto out = std::back_inserter(text);
  if (loss.fatal) {
    fmt::format_to(out, "  after some loss {}\n", at_none_text(truss, loss.uncertain, *loss.fatal));
    return;
  }
  const auto& ends = loss.ends;
  if (loss.target) {
    const auto answer = loss.reaches_target
                            ? fmt::format("{}, {}", *loss.reaches_target ? "yes" : "no",
                                          answer::standing_word(support::Standing::proved))
                            : "open";
    fmt::format_to(out, "  load factor at least {}: {}\n", *loss.target, answer);
  } else if (loss.proved()) {
    fmt::format_to(out, "  load factor {}\n", factor_text(ends));
    return;
  } else if (ends.lower) {
    fmt::format_to(out, "  load factor at least {}, {}\n",
                   support::rounded_down(ends.lower->value, support::digits_of_table),
                   answer::standing_word(ends.lower->standing));
  } else {
    text += "  a lower bound of the load factor is not known\n";
  }
  if (ends.upper)
    fmt::format_to(out, "  load factor after the worst loss known at most {}, {}\n",
                   support::rounded_up(ends.upper->value, support::digits_of_table),
                   answer::standing_word(ends.upper->standing));
}

}  // namespace

std::vector<std::string> names_of(const LimitProblem& problem, const std::vector<int>& members) {
  std::vector<std::string> names;
  names.reserve(members.size());
  for (const int i : members) names.push_back(problems::member_name(problem, i));
  return names;
}

const char* loss_state(LoadStatus status) {
  return status == LoadStatus::collapses     ? "collapses"
         : status == LoadStatus::not_carried ? "not-carried"
                                             : "undetermined";
}

std::string loss_text(const LimitProblem& problem, const problems::Structure& truss,
                      const LossAnswer& loss) {
  std::string text = fmt::format(
      "\nloss of up to {} of {}{}{}\n", loss.maximum, answer::counted(loss.eligible, "member"),
      loss.uncertain ? ", under every admissible load" : "",
      loss.sudden == 1 ? std::string() : fmt::format(", dynamic factor {}", loss.sudden));
  write_ends(text, truss, loss);
  const auto out = std::back_inserter(text);
  if (loss.lost.empty()) {
    text += "  no loss is known that lowers the factor\n";
  } else {
    fmt::format_to(out, "  worst loss known: {}\n", fmt::join(names_of(problem, loss.lost), " "));
  }
  if (loss.fatal) text += fatal_text(problem, truss, loss);
  if (loss.uncertain && !loss.lost.empty()) text += critical_load_text(truss, problem, loss.zeta);
  if (loss.collapse && loss.ends.at_most() < 0)
    fmt::format_to(out, "  negative: {}{} alone then collapses the structure\n",
                   loss.sudden == 1 ? std::string() : fmt::format("{} times ", loss.sudden),
                   loss.uncertain ? "an admissible dead load" : "the dead load");
  if (loss.undecided > 0)
    fmt::format_to(
        out, "  {} numerically undecided\n",
        answer::counted(loss.undecided, "node") + (loss.undecided == 1 ? " is" : " are"));
  text += singles_text(problem, loss);
  if (loss.search != engine::Status::solved)
    fmt::format_to(out, "  stopped early ({})\n", answer::status_name(loss.search));
  const auto& counts = loss.counts;
  fmt::format_to(out, "  evidence: {}, {}, {}, {}\n", answer::counted(counts.rounds, "round"),
                 answer::counted(counts.nodes, "node"),
                 answer::counted(counts.states, "carrying stress state"),
                 answer::counted(counts.programs, "linear program"));
  return text;
}

ordered_json loss_json(const LimitProblem& problem, const problems::Structure& truss,
                       const LossAnswer& loss) {
  ordered_json json{{"eligible", loss.eligible},
                    {"standing", answer::name_of(loss.standing)},
                    {"undecided", loss.undecided}};
  auto singles = ordered_json::array();
  for (const auto& single : loss.singles) {
    const bool finite = single.status == LoadStatus::collapses;
    singles.push_back({{"member", problems::member_name(problem, single.member)},
                       {"index", single.member},
                       {"factor", finite ? ordered_json(single.factor) : ordered_json()},
                       {"state", loss_state(single.status)}});
  }
  json["single"] = std::move(singles);
  json["lost_index"] = loss.lost;
  if (loss.zeta.size() > 0) {
    json["critical_parameters"] = parameters_json(problem, loss.zeta);
    json["critical_load"] = load_json(problem, problems::dead_load(problem, loss.zeta));
    if (!truss.actions.empty()) json["critical_factors"] = factors_json(truss, problem, loss.zeta);
  }
  if (loss.collapse) {
    json["forces"] = numbers(loss.collapse->forces);
    json["collapse_mode"] = mode_json(problem, loss.collapse->motion, loss.lost);
  } else if (loss.fatal_motion.size() > 0) {
    json["collapse_mode"] = mode_json(problem, loss.fatal_motion, loss.lost);
  }
  return json;
}

namespace {

// The bounds of the factor after a loss in one case. @param loss of this case at some strength
support::Bracket factor_after_loss(const LimitCase& each, const std::optional<LossAnswer>& loss) {
  auto ends = loss ? loss->ends : support::Bracket{};
  if (!ends.upper) ends.upper = each.found.answer.nominal_factors.largest.upper;
  return ends;
}

}  // namespace

answer::MemberLoss member_loss(std::span<const LimitCase> cases,
                               const limit::LimitParameters& parameters) {
  const auto& asked = *parameters.loss;
  const auto& governs = governing(cases);
  answer::MemberLoss answer{.maximum = static_cast<std::uint64_t>(asked.maximum),
                            .cases = cases.size(),
                            .uncertain = parameters.alpha.value_or(0) > 0};
  answer.target = asked.at_least;
  answer.kept = names_of(governs.problem, asked.kept);
  answer.struts = with_struts(cases);
  answer.sudden = asked.sudden;
  if (const auto& worst = governs.found.loss) {
    answer.lost = names_of(governs.problem, worst->lost);
    answer.fatal = worst->fatal;
  }
  if (answer.fatal) {
    if (answer.target && is_proved(*answer.fatal)) answer.reached = false;
    return answer;
  }
  answer.factor.upper = factor_after_loss(governs, governs.found.loss).upper;
  std::optional<support::Bound> lower;
  bool known = true;
  bool reached = true;
  bool missed = false;
  for (const auto& each : cases) {
    const auto& loss = each.found.loss;
    const auto ends = factor_after_loss(each, loss);
    missed = missed || (loss && !loss->reaches_target.value_or(true)) ||
             (answer.target && is_proved(ends.upper) && ends.at_most() < *answer.target);
    const auto& carried = answer.struts ? each.found.residual_loss : loss;
    reached = reached && carried && carried->reaches_target.value_or(false);
    known = known && carried && carried->ends.lower;
    if (!known) continue;
    const auto& bound = *carried->ends.lower;
    lower = lower ? support::Bound{std::min(lower->value, bound.value),
                                   support::both(lower->standing, bound.standing)}
                  : bound;
  }
  if (known) answer.factor.lower = lower;
  if (answer.target && (reached || missed)) answer.reached = reached;
  return answer;
}

}  // namespace kusabi::run
