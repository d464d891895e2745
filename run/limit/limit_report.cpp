// Table of `kusabi limit`.
#include "run/limit/limit_report.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "problems/limit/half_widths.hpp"
#include "run/pictures/limit_values.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using limit::RootStatus;
using problems::LimitProblem;

// Addition to the name of a factor of a truss with struts. @param known its upper bound is
const char* strength_text(const LimitReport& report, bool known) {
  if (!report.residual) return "";
  return known ? ", all struts at their strength: an upper value"
               : ", all struts at their strength";
}

void write_mode(std::string& text, const LimitProblem& problem,
                const limit::LimitCollapse& collapse) {
  const auto mode = named_mode(problem, collapse.motion);
  fmt::format_to(std::back_inserter(text), "  collapse mode: {} {}{}, {} {}\n",
                 answer::counted(mode.moving, "node"), mode.moving == 1 ? "moves" : "move",
                 mode.along_reference ? " along the reference load" : "",
                 answer::counted(mode.yielding.size(), "member"),
                 mode.yielding.size() == 1 ? "yields" : "yield");
  text += yielding_text(mode, 4);
}

// Note on load factor zero, if it is not carried.
void write_zero(std::string& text, std::string_view load, double factor) {
  if (factor < 0) {
    fmt::format_to(std::back_inserter(text), "  negative: {} alone collapses the structure\n",
                   load);
  }
}

void write_nominal(std::string& text, const LimitReport& report) {
  const auto& [minimum, largest, gap] = report.answer.nominal_factors;
  fmt::format_to(std::back_inserter(text), "{} {}{}\n",
                 has_ranges(report.truss)
                     ? "with all factors of actions in the middle of their ranges: load factor"
                     : "nominal load factor",
                 factor_text(largest), strength_text(report, largest.upper.has_value()));
  write_zero(text, "the dead load", largest.at_most());
  if (minimum.at_least() > 0 && minimum.at_most() <= largest.at_least()) {
    const auto [low, high] =
        support::inside(minimum.at_most(), largest.at_least(), support::digits_of_table);
    fmt::format_to(std::back_inserter(text),
                   "  the dead load is carried at load factors from {} to {}, not at zero\n", low,
                   high);
  }
  write_mode(text, report.problem, *report.answer.nominal);
  text += utilisation_text(report.problem, *report.answer.nominal);
}

void write_ends(std::string& text, const limit::LimitWorstCase& worst) {
  const auto out = std::back_inserter(text);
  if (worst.as_printed) {
    text += printed_ends_text(worst);
    return;
  }
  fmt::format_to(out, "  load factor {}\n", factor_text(worst.ends));
  if (!worst.proved() && worst.ends.has_proved_ends() && worst.search == engine::Status::solved)
    text += "  open: the two bounds differ\n";
}

// The loads of a statement on the governing case alone.
std::string loads_of_governing(const LimitReport& report) {
  return loads_text({&governing(report.cases), 1}, report.options.parameters.alpha);
}

// "worst case of 4 uncertain loads, alpha = 2 kN": heading of the worst case.
std::string heading_of_worst(const LimitReport& report) {
  if (!report.truss.actions.empty()) return "combinations of actions";
  const auto& problem = report.problem;
  const auto alpha = problems::common_half_width(problem, *report.options.parameters.alpha);
  const auto unit = unit_of_alpha(problem);
  const auto half_width =
      alpha ? fmt::format("alpha = {}{}{}", *alpha, unit ? " " : "", unit.value_or(""))
            : std::string("each within its own half-width");
  if (alpha == 0) return "no load is uncertain: " + half_width;
  return fmt::format("worst case of {}, {}",
                     answer::counted(problem.uncertain_count(), "uncertain load"), half_width);
}

// Number of uncertain loads, or of actions, that change the reference load.
void write_along(std::string& text, const LimitReport& report) {
  const auto& problem = report.problem;
  if (problems::common_half_width(problem, *report.options.parameters.alpha) == 0) return;
  const auto along = std::ranges::count_if(
      problem.uncertain, [&](const auto& column) { return works_with_reference(problem, column); });
  if (along == 0) return;
  fmt::format_to(
      std::back_inserter(text),
      "  {} {} along the reference load; the load factor does not include {}\n",
      answer::counted(along, report.truss.actions.empty() ? "uncertain load" : "other action"),
      along == 1 ? "acts" : "act", along == 1 ? "it" : "them");
}

// Load factors carried under all loads, and the load at their lower end if zero is not among them.
void write_interval(std::string& text, const LimitReport& report) {
  const auto interval = guaranteed_interval(report.answer, report.residual);
  if (report.residual) text += "  while no strut falls below its residual strength:\n";
  const auto loads = loads_of_governing(report);
  text += "  " + interval_text(interval, loads) + '\n';
  text += "  " + passed_text(interval) + '\n';
  const auto& carrying = report.residual ? *report.residual : report.answer;
  const auto& reversed = carrying.reversed;
  const bool zero_is_excluded = guaranteed_interval(carrying).minimum.at_least() > 0;
  if (!reversed || reversed->zeta.size() == 0 || !zero_is_excluded) return;
  text += "  load that determines the least of these factors:\n" +
          critical_load_text(report.truss, report.problem, reversed->zeta);
}

// Number of cuts, nodes, corners and programs.
std::string evidence_text(const limit::LimitWorstCase& worst) {
  if (worst.cuts == 0 && worst.corners > 0) {
    return fmt::format(
        "  static evidence: {} of the uncertain loads; linear programs: {}, {} in the tree\n",
        answer::counted(worst.corners, "corner"),
        answer::counted(worst.counts.load_factors, "load factor"), worst.tree_programs);
  }
  return fmt::format(
      "  static evidence: {}, {}{}; linear programs: {}, {}, {} for cuts, {} in the tree\n",
      answer::counted(worst.cuts, "cut"), answer::counted(worst.nodes, "node"),
      worst.corners == 0 ? ""
                         : fmt::format(", of these {}", answer::counted(worst.corners, "corner")),
      answer::counted(worst.counts.load_factors, "load factor"),
      answer::counted(worst.counts.relaxations, "relaxation"), worst.counts.pricings,
      worst.tree_programs);
}

void write_worst(std::string& text, const LimitReport& report) {
  const auto& problem = report.problem;
  const auto& worst = *report.answer.worst;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "\n{}{}\n", heading_of_worst(report),
                 strength_text(report, worst.ends.upper.has_value()));
  write_along(text, report);
  const char* const some_load =
      report.truss.actions.empty() ? "admissible dead load" : "combination of actions";
  if (worst.status == RootStatus::not_carried) {
    fmt::format_to(out, "  {}\n", at_none_text(report.truss, true, worst.standing));
    text += critical_load_text(report.truss, problem, worst.zeta);
  } else {
    write_ends(text, worst);
    if (worst.collapse) {
      write_zero(text, "some " + std::string(some_load), worst.ends.at_most());
      write_mode(text, problem, *worst.collapse);
      text += utilisation_text(problem, *worst.collapse);
    }
    if (worst.zeta.size() > 0) text += critical_load_text(report.truss, problem, worst.zeta);
    if (!worst.as_printed) write_interval(text, report);
  }
  if (worst.zero_one) text += zero_one_text(worst);
  if (worst.search != engine::Status::solved) {
    fmt::format_to(out, "  stopped early ({})\n", answer::status_name(worst.search));
  }
  if (worst.as_printed) return;
  text += evidence_text(worst);
}

// Reason why there is no nominal factor.
std::string no_nominal(const limit::LimitAnswer& found) {
  if (const auto standing = limit::at_no_factor(found)) {
    return fmt::format(
        "the nominal dead load is not carried at any load factor of either sign, {}\n",
        answer::standing_word(*standing));
  }
  if (found.rest != engine::Status::solved) {
    return fmt::format("stopped early ({}) before the nominal load factor was found\n",
                       answer::status_name(found.rest));
  }
  return "open: the nominal load factor is not known\n";
}

}  // namespace

std::string LimitReport::table(const Page& page) const {
  std::string text = cases.size() > 1 ? cases_text(cases, options.parameters) : std::string();
  if (!answer.nominal) return text + page.warning(no_nominal(answer));
  const auto out = std::back_inserter(text);
  write_nominal(text, *this);
  if (loss) text += loss_text(problem, truss, *loss);
  if (answer.worst) write_worst(text, *this);
  if (residual) text += strut_text(*this);
  if (!answer.samples.empty()) {
    const auto [minimum, greatest] = std::ranges::minmax(answer.samples);
    double sum = 0;
    for (const double factor : answer.samples) sum += factor;
    fmt::format_to(out, "\n{}: load factors{} {:.6g} ... {:.6g}, mean {:.6g}\n",
                   answer::counted(answer.samples.size(), "random dead load"),
                   residual ? " with all struts at their strength" : "", minimum, greatest,
                   sum / static_cast<double>(answer.samples.size()));
  }
  text += curves_text(*this);
  if (answer.rest != engine::Status::solved) {
    text += page.warning(fmt::format("stopped early ({}): the results are incomplete\n",
                                     answer::status_name(answer.rest)));
  }
  return text;
}

}  // namespace kusabi::run
