// Both factors of the bracket, each with its standing.
#include <algorithm>
#include <iterator>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/fields.hpp"
#include "answer/values.hpp"
#include "answer/words.hpp"
#include "problems/limit/utilisation.hpp"
#include "run/limit/limit_report.hpp"
#include "run/pictures/limit_values.hpp"

namespace kusabi::run {
namespace {

using limit::LimitAnswer;

/// Utilisation from which on a strut is at its strength: that of a collapse is 1 up to rounding.
constexpr double at_strength = 1 - 1e-9;

// Struts in compression at their strength at the collapse, or the worst one.
std::vector<std::string> struts_at_strength(const LimitReport& report) {
  const auto& worst = report.answer.worst;
  const auto& collapse = report.loss                ? report.loss->collapse
                         : worst && worst->collapse ? worst->collapse
                                                    : report.answer.nominal;
  std::vector<std::string> names;
  if (!collapse) return names;
  // After a sudden loss the strengths are divided by the dynamic factor.
  const double sudden = report.loss && report.loss->collapse ? report.loss->sudden : 1;
  const Eigen::VectorXd used = problems::utilisation(report.problem, sudden * collapse->forces);
  for (int i = 0; i < report.problem.member_count(); ++i) {
    const auto& residual = report.problem.members[static_cast<std::size_t>(i)].yield->residual;
    const bool strut = residual && *residual < report.problem.compression(i);
    if (strut && collapse->forces(i) < 0 && used(i) >= at_strength)
      names.push_back(problems::member_name(report.problem, i));
  }
  return names;
}

// Bounds of the requested factor: after the worst loss of members, in the worst case, or the nominal
// one. A stopped run may have the nominal factor alone, which is then not the requested one.
support::Bracket requested(const LimitReport& report, const LimitAnswer& answer,
                           const std::optional<limit::LossAnswer>& loss) {
  if (loss) return loss->ends;
  if (answer.worst) return answer.worst->ends;
  const auto& parameters = report.options.parameters;
  return parameters.alpha || parameters.loss ? support::Bracket{} : answer.nominal_factors.largest;
}

std::string remaining_text(const LimitReport& report, const support::Bracket& ends,
                           const LimitAnswer& answer,
                           const std::optional<limit::LossAnswer>& loss) {
  if (loss && loss->fatal)
    return "after a loss " + at_none_text(report.truss, loss->uncertain, *loss->fatal);
  if (auto none = at_none_text(report.truss, answer)) return *none;
  if (!ends.lower && !ends.upper) return "open";
  return fmt::format("{}load factor {}", loss ? "after the worst loss " : "", factor_text(ends));
}

}  // namespace

std::string strut_text(const LimitReport& report) {
  std::string text = "\nstruts, which lose force after they have buckled\n";
  const auto out = std::back_inserter(text);
  const auto full = requested(report, report.answer, report.loss);
  const auto residual = requested(report, *report.residual, report.residual_loss);
  fmt::format_to(out, "  all at their strength: {}{}\n",
                 remaining_text(report, full, report.answer, report.loss),
                 full.upper ? "; an upper value" : "");
  fmt::format_to(out, "  all at their residual strength: {}{}\n",
                 remaining_text(report, residual, *report.residual, report.residual_loss),
                 residual.lower ? "; a lower value" : "");
  if (report.residual->worst) {
    const auto carried = guaranteed_interval(*report.residual);
    if (!carried.has_factors())
      fmt::format_to(out, "    {}\n",
                     interval_text(carried, loads_text({&governing(report.cases), 1},
                                                       report.options.parameters.alpha)));
  }
  const auto names = struts_at_strength(report);
  fmt::format_to(out, "  struts at their strength at the collapse: {}\n",
                 names.empty() ? std::string("none") : fmt::format("{}", fmt::join(names, " ")));
  return text;
}

nlohmann::ordered_json strut_json(const LimitReport& report) {
  const auto& residual = *report.residual;
  nlohmann::ordered_json json{
      {"at_strength", struts_at_strength(report)},
      {"nominal", residual.nominal ? answer::number_or_null(residual.nominal->factor)
                                   : nlohmann::ordered_json()},
      {"at_no_factor", limit::at_no_factor(residual).has_value()}};
  if (residual.worst) json.update(interval_json(guaranteed_interval(residual)));
  if (const auto& loss = report.residual_loss) {
    json.update({{"factor", answer::written(loss->ends)},
                 {"fatal", answer::written(loss->fatal)},
                 {"lost", names_of(report.problem, loss->lost)},
                 {"member_loss", loss_json(report.problem, report.truss, *loss)}});
  }
  return json;
}

std::string strut_sentence(std::span<const LimitCase> cases) {
  if (std::ranges::any_of(cases, [](const auto& each) {
        const auto& loss = each.found.loss;
        return limit::at_no_factor(each.found.answer) || (loss && loss->fatal);
      }))
    return {};
  const auto sentence = [](const char* after, const LimitCase& each, bool uncertain,
                           support::Standing standing) {
    return fmt::format(
        "With all struts at their residual strength{} {} is carried at no load "
        "factor{}.",
        after, load_without_factor(each.truss, uncertain), answer::unless_proved(standing));
  };
  for (const auto& each : cases) {
    const auto& [residual, loss] = std::tie(each.found.residual, each.found.residual_loss);
    const auto none = residual ? limit::at_no_factor(*residual) : std::nullopt;
    if (none) return sentence("", each, residual->worst || has_ranges(each.truss), *none);
    if (loss && loss->fatal)
      return sentence(", after the worst loss,", each, loss->uncertain, *loss->fatal);
  }
  return {};
}

}  // namespace kusabi::run
