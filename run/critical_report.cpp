// The table and the JSON of `kusabi critical`.
#include "run/critical_report.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "run/problem_summary.hpp"

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
  ordered_json json = {{"contact", candidate_names(problem, entry.pattern.contact)},
                       {"separated", candidate_names(problem, entry.pattern.separated)},
                       {"lower", entry.lower},
                       {"upper", entry.upper}};
  if (entry.reaction.empty()) return json;
  json["reaction"] = candidate_rows(entry.reaction, problem.dimension);
  json["displacement"] = candidate_rows(entry.displacement, problem.dimension);
  return json;
}

}  // namespace

void CriticalFindings::conclude(double dead) {
  std::sort(patterns.begin(), patterns.end(), [](const auto& a, const auto& b) {
    if (a.upper != b.upper) return a.upper < b.upper;
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
    fmt::format_to(out, "\n{:>5}  {:>14}  {:>14}  {}\n", "", "dead at", "alive at",
                   "in contact (U)");
  }
  std::size_t number = 0;
  for (const auto& entry : findings.patterns) {
    const auto contact = candidate_names(problem, entry.pattern.contact);
    fmt::format_to(out, "{:>5}  {:>14.10g}  {:>14.10g}  {}\n", ++number, entry.lower, entry.upper,
                   fmt::join(contact, " "));
  }
  const auto* const times =
      problems::uniform_friction(problem) ? "" : " (times that of each candidate)";
  if (findings.upper) {
    fmt::format_to(out,
                   "\ncritical friction coefficient{}: between {:.10g} and {:.10g}: nothing can "
                   "wedge below, something can above\n",
                   times, findings.lower, *findings.upper);
  } else if (findings.status == "solved") {
    fmt::format_to(out, "\nnothing can wedge at a friction coefficient{} below {:.10g}\n", times,
                   findings.lower);
  }
  if (findings.doubtful != 0) {
    fmt::format_to(
        out,
        "{} patterns with t* = 0 from there on could not be decided: the lower end allows "
        "for them\n",
        findings.doubtful);
  }
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
  ordered_json bracket = {{"lower", findings.lower}, {"upper", nullptr}};
  if (findings.upper) bracket["upper"] = *findings.upper;
  ordered_json chosen = {{"method", way_name(options.way)}, {"width", options.width}};
  chosen["mu_max"] = options.most ? ordered_json(*options.most) : ordered_json();
  return {{"command", "critical"},
          {"version", KUSABI_VERSION},
          {"problem", problem_json(problem, options.file)},
          {"options", std::move(chosen)},
          {"status", findings.status},
          {"result",
           {{"critical_friction", std::move(bracket)},
            {"pattern", patterns.empty() ? ordered_json() : patterns.front()},
            {"doubtful", findings.doubtful},
            {"patterns", std::move(patterns)}}},
          {"statistics", findings.statistics}};
}

}  // namespace kusabi::run
