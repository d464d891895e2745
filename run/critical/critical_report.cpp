// Table and JSON of `kusabi critical`.
#include <iterator>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "run/critical/critical.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/values.hpp"
#include "run/wedged/configuration_files.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

/// @param whole nothing: signs, brackets and reactions only
ordered_json entry_json(const problems::WedgedProblem& problem, const wedged::CriticalEntry& entry,
                        const WholeStateJson* whole) {
  ordered_json json = pattern_json(problem, entry.block, entry.pattern);
  json["lower"] = entry.lower;
  json["upper"] = answer::number_or_null(entry.upper);
  if (entry.reaction.empty()) return json;
  json["reaction"] = block_rows(problem, entry.block, entry.reaction);
  if (whole == nullptr) return json;
  whole->add_to(json, entry.block, entry.reaction, entry.displacement);
  return json;
}

std::vector<std::uint64_t> columns_of(const wedged::CriticalTree::Tally& tally) {
  return {tally.branched, tally.infeasible, tally.leaves, tally.programs};
}

// Cost of the search for the bracket; empty if there was none.
std::string ranks_text(const wedged::CriticalFindings& findings, const Page& page) {
  if (!findings.global_ranks.empty()) {
    RankTable table({"branched", "pruned", "leaves", "programs"});
    for (const auto& [statistics, tally] : findings.global_ranks) {
      table.add(statistics, columns_of(tally));
    }
    return table.text(page.width);
  }
  if (findings.bisection_ranks.empty()) return {};
  RankTable table({"programs"});
  for (const auto& [statistics, tally] : findings.bisection_ranks) {
    table.add(statistics, {tally.programs});
  }
  return table.text(page.width);
}

const char* phase_name(wedged::CriticalPhase phase) {
  switch (phase) {
    case wedged::CriticalPhase::start:
      return "start";
    case wedged::CriticalPhase::primal:
      return "primal";
    case wedged::CriticalPhase::form:
      return "form";
    case wedged::CriticalPhase::list:
      return "list";
    case wedged::CriticalPhase::trial:
      return "trial";
    case wedged::CriticalPhase::dive:
      return "dive";
    case wedged::CriticalPhase::coarse:
      return "coarse";
    case wedged::CriticalPhase::fine:
      return "fine";
    case wedged::CriticalPhase::patterns:
      return "patterns";
    case wedged::CriticalPhase::coefficients:
      return "coefficients";
    case wedged::CriticalPhase::lower_bound:
      return "lower end";
    case wedged::CriticalPhase::upper_bound:
      break;
  }
  return "upper end";
}

// Name in the table; result files keep that of their first version.
const char* shown_name(wedged::CriticalPhase phase) {
  if (phase == wedged::CriticalPhase::lower_bound) return "lower bound";
  return phase == wedged::CriticalPhase::upper_bound ? "upper bound" : phase_name(phase);
}

// Searches, one per line, and their sum.
std::string costs_text(const wedged::CriticalFindings& findings) {
  auto text =
      fmt::format("\n{:<12}  {:>12}  {:>9}  {:>9}\n", "search", "friction", "nodes", "programs");
  std::uint64_t opened = 0;
  std::uint64_t programs = 0;
  const auto out = std::back_inserter(text);
  for (const auto& cost : findings.costs) {
    fmt::format_to(out, "{:<12}  {:>12.10g}  {:>9}  {:>9}\n", shown_name(cost.phase), cost.friction,
                   cost.opened, cost.programs);
    opened += cost.opened;
    programs += cost.programs;
  }
  fmt::format_to(out, "{:<12}  {:>12}  {:>9}  {:>9}\n", "all", "", opened, programs);
  return text;
}

}  // namespace

ordered_json critical_statistics(const wedged::CriticalFindings& findings) {
  const auto counts = [](const auto& tally) { return counts_json(tally); };
  ordered_json statistics;
  if (!findings.global_ranks.empty()) {
    statistics["ranks"] = rank_reports(findings.global_ranks, counts);
  } else if (!findings.bisection_ranks.empty()) {
    statistics["ranks"] = rank_reports(findings.bisection_ranks, counts);
  }
  auto searches = ordered_json::array();
  for (const auto& [phase, friction, opened, programs] : findings.costs) {
    searches.push_back({{"phase", phase_name(phase)},
                        {"friction", friction},
                        {"opened", opened},
                        {"programs", programs}});
  }
  statistics["searches"] = std::move(searches);
  return statistics;
}

std::string critical_table(const CriticalOptions& options, const problems::WedgedProblem& problem,
                           const wedged::CriticalGrid& grid,
                           const wedged::CriticalFindings& findings, const Page& page) {
  std::string text;
  auto out = std::back_inserter(text);
  if (!findings.patterns.empty()) {
    fmt::format_to(out, "\n{:>5}  {:>16}  {:>16}  {}\n", "", "absent at", "present at",
                   "in contact (U); others separated (R)");
  }
  std::size_t number = 0;
  for (const auto& entry : findings.patterns) {
    if (number == options.top) {
      fmt::format_to(out, "{:>5}  {} more\n", "…", findings.patterns.size() - number);
      break;
    }
    const auto shown = entry.upper
                           ? support::in_table(entry.lower, *entry.upper)
                           : support::ShownBracket{
                                 support::rounded_down(entry.lower, support::digits_of_table), "?"};
    fmt::format_to(out, "{:>5}  {:>16}  {:>16}  {}\n", ++number, shown.lower, shown.upper,
                   contact_text(problem, entry.pattern));
  }
  text += '\n' + answer::bracket_line(critical_bracket(problem, grid, findings));
  if (!finds_smallest_only(options.parameters.strategy) && findings.bracket.upper) {
    fmt::format_to(out, "(of the {} at {})\n", answer::counted(findings.patterns.size(), "pattern"),
                   grid.maximum);
  }
  return text + '\n' + ranks_text(findings, page) + costs_text(findings);
}

ordered_json critical_json(const CriticalOptions& options, const problems::WedgedProblem& problem,
                           const wedged::CriticalFindings& findings, const WholeStateJson& whole) {
  auto patterns = ordered_json::array();
  for (std::size_t i = 0; i < findings.patterns.size(); ++i) {
    const bool all = options.whole || i < whole_unless_requested;
    patterns.push_back(entry_json(problem, findings.patterns[i], all ? &whole : nullptr));
  }
  return {{"patterns", std::move(patterns)}};
}

void write_critical_csv(std::ostream& out, const problems::WedgedProblem& problem,
                        const wedged::CriticalFindings& findings) {
  CsvWriter csv(out);
  csv.word("pattern");
  add_pattern_columns(csv);
  csv.word("lower").word("upper");
  add_configuration_columns(csv, problem);
  csv.end_row();
  std::size_t number = 0;
  for (const auto& entry : findings.patterns) {
    csv.count(++number);
    add_pattern(csv, problem, entry.block, entry.pattern);
    csv.number(entry.lower).number(entry.upper);
    const bool known = !entry.reaction.empty();
    const auto of_all = [&](const std::vector<double>& values) {
      return known ? of_all_candidates(problem, entry.block, values) : std::vector<double>{};
    };
    add_configuration(csv, problem, of_all(entry.reaction), of_all(entry.displacement));
    csv.end_row();
  }
}

}  // namespace kusabi::run
