// The table and the JSON of `kusabi critical`.
#include "run/critical/critical_report.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "run/output/values.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

const char* way_name(CriticalWay way) {
  switch (way) {
    case CriticalWay::global:
      return "global";
    case CriticalWay::newton:
      return "newton";
    case CriticalWay::bisection:
      break;
  }
  return "bisection";
}

ordered_json entry_json(const problems::WedgedProblem& problem, const CriticalEntry& entry) {
  ordered_json json = pattern_json(problem, entry.block, entry.pattern);
  json["lower"] = entry.lower;
  json["upper"] = number_or_null(entry.upper);
  if (entry.reaction.empty()) return json;
  json["reaction"] = block_rows(problem, entry.block, entry.reaction);
  json["displacement"] = block_rows(problem, entry.block, entry.displacement);
  return json;
}

double or_infinity(const std::optional<double>& number) {
  return number.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

void CriticalFindings::conclude(double dead) {
  std::sort(patterns.begin(), patterns.end(), [](const auto& a, const auto& b) {
    const double from_a = or_infinity(a.upper);
    const double from_b = or_infinity(b.upper);
    if (from_a != from_b) return from_a < from_b;
    if (a.block != b.block) return a.block < b.block;
    return a.pattern.contact < b.pattern.contact;
  });
  lower = dead;
  if (patterns.empty()) return;
  upper = patterns.front().upper;
  for (const auto& entry : patterns) lower = std::min(lower, entry.lower);
}

std::string critical_table(const CriticalOptions& options, const problems::WedgedProblem& problem,
                           const CriticalFindings& findings) {
  std::string text;
  auto out = std::back_inserter(text);
  if (!findings.patterns.empty()) {
    fmt::format_to(out, "\n{:>5}  {:>16}  {:>16}  {}\n", "", "dead at", "alive at",
                   "in contact (U)");
  }
  std::size_t number = 0;
  for (const auto& entry : findings.patterns) {
    const auto& [contact, separated, at_rest] = entry.pattern;
    fmt::format_to(out, "{:>5}  {:>16.12g}  {:>16}  {}{}\n", ++number, entry.lower,
                   entry.upper ? fmt::format("{:.12g}", *entry.upper) : "?",
                   listed(candidate_names(problem, contact)),
                   at_rest == 0
                       ? ""
                       : fmt::format("  at rest: {}", listed(candidate_names(problem, at_rest))));
  }
  const auto* const times =
      problems::uniform_friction(problem) ? "" : " (times that of each candidate)";
  if (findings.upper) {
    fmt::format_to(out,
                   "\ncritical friction coefficient{}: between {:.12g} and {:.12g}: nothing can "
                   "wedge below, something can above\n",
                   times, findings.lower, *findings.upper);
  } else if (findings.status == "solved") {
    fmt::format_to(out, "\nnothing can wedge at a friction coefficient{} below {:.12g}\n", times,
                   findings.lower);
  }
  if (findings.upper && findings.status == "solved" && !findings.upper_proved) {
    text +=
        "What wedges at the upper end is a tie: it holds within the rounding of the file's numbers "
        "and is not proved in exact arithmetic.\n";
  }
  for (const auto& sentence : findings.open) fmt::format_to(out, "Open: {}.\n", sentence);
  if (options.way != CriticalWay::global && findings.upper) {
    fmt::format_to(out, "(of the {} patterns that live at {})\n", findings.patterns.size(),
                   options.most.value_or(0));
  }
  return text + '\n' + findings.ranks;
}

ordered_json critical_json(const CriticalOptions& options, const problems::WedgedProblem& problem,
                           const CriticalFindings& findings) {
  auto patterns = ordered_json::array();
  for (const auto& entry : findings.patterns) patterns.push_back(entry_json(problem, entry));
  ordered_json chosen = {{"method", way_name(options.way)}, {"width", options.width}};
  chosen["mu_max"] = number_or_null(options.most);
  return {{"command", "critical"},
          {"version", KUSABI_VERSION},
          {"problem", problem_json(problem, options.file)},
          {"options", std::move(chosen)},
          {"status", findings.status},
          {"result",
           {{"critical_friction",
             {{"lower", findings.lower},
              {"upper", number_or_null(findings.upper)},
              {"lower_proved", findings.lower_proved},
              {"upper_proved", findings.upper_proved}}},
            {"pattern", patterns.empty() ? ordered_json() : patterns.front()},
            {"open", findings.open},
            {"patterns", std::move(patterns)}}},
          {"statistics", findings.statistics}};
}

}  // namespace kusabi::run
