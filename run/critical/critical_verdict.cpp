// Both bounds with their standing, and the pattern that sticks first.
#include "run/critical/critical_verdict.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "run/output/name_ranges.hpp"
#include "run/wedged/nearest_failure.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

// A pattern that is feasible at the upper bound, where others may be as well, and its slipping
// candidates; in an open bracket, the pattern known to stick with the least friction.
std::string first_way(const problems::WedgedProblem& problem, const wedged::CriticalEntry& first,
                      bool closed) {
  auto text = fmt::format("{} number 1 (in contact: {})",
                          closed ? "It sticks there in pattern"
                                 : "The pattern known to stick with the least friction is",
                          contact_text(problem, first.pattern));
  if (!closed || first.reaction.empty() || !first.upper) return text + '.';
  const auto nearest = nearest_failure(problem, *first.upper, first.block, first.pattern,
                                       first.reaction, first.displacement);
  if (nearest.slips_there.empty()) return text + '.';
  support::IndexSet slips;
  for (const int i : nearest.slips_there) slips.insert(i);
  return fmt::format("{}; with less friction {} {}.", text,
                     with_ranges(candidate_names(problem, slips)),
                     nearest.slips_there.size() == 1 ? "slips" : "slip");
}

}  // namespace

answer::CriticalBracket critical_bracket(const CriticalOptions& options,
                                         const problems::WedgedProblem& problem,
                                         const wedged::CriticalFindings& findings) {
  answer::CriticalBracket found{
      .bracket = findings.bracket,
      .factor = !problems::uniform_friction(problem),
      .maximum = options.parameters.maximum.value_or(wedged::default_max_friction),
      .width = wedged::grid_of(problem, options.parameters).width};
  // A bound of zero means only that nothing sticks without friction: the search has not advanced.
  if (found.bracket.at_least() <= 0) found.bracket.lower.reset();
  found.grounds =
      findings.exact ? answer::Grounds::exact_arithmetic : answer::Grounds::solver_bounds;
  found.displacement_ratio = findings.displacement_ratio;
  using enum wedged::OpenPoint;
  found.wide = std::ranges::find(findings.open_points, wide_bracket) != findings.open_points.end();
  found.patterns_open =
      (findings.bracket.upper && findings.patterns.empty()) ||
      std::ranges::find(findings.open_points, list_not_complete) != findings.open_points.end();
  return found;
}

answer::Verdict critical_verdict(const CriticalOptions& options,
                                 const problems::WedgedProblem& problem,
                                 const wedged::CriticalFindings& findings) {
  const auto bracket = critical_bracket(options, problem, findings);
  answer::Verdict verdict{.ended = findings.status, .answer = bracket};
  const bool closed =
      findings.status == engine::Status::solved && !bracket.wide && bracket.bracket.lower;
  if (findings.bracket.upper && !findings.patterns.empty())
    verdict.details.push_back(first_way(problem, findings.patterns.front(), closed));
  if (!options.certificate.empty()) {
    if (!findings.lower_recorded)
      verdict.missing.emplace_back("There is no certificate of the lower bound.");
    if (findings.bracket.upper && !findings.upper_recorded)
      verdict.missing.emplace_back("There is no certificate of the upper bound.");
  }
  return verdict;
}

}  // namespace kusabi::run
