// Both bounds with their standing, and the pattern that sticks first.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "run/critical/critical.hpp"
#include "run/wedged/contact_words.hpp"

namespace kusabi::run {
namespace {

// A pattern that is feasible at the upper bound, where others may be as well; in a closed bracket
// also its slipping candidates.
std::string first_way(const problems::WedgedProblem& problem, const wedged::CriticalEntry& first,
                      bool closed) {
  auto text = fmt::format(
      "One way is pattern 1, with {}",
      contact_words(problem, first.block, first.pattern.contact, first.pattern.inactive));
  if (closed && !first.reaction.empty()) {
    const auto need = friction_need(problem, first.block, first.pattern.contact, first.reaction);
    if (!need.slips.empty())
      text += fmt::format("; with less friction {}",
                          slip_words(problem, first.block, first.pattern.contact, need));
  }
  return text + '.' + (first.upper ? angle_sentence(problem, *first.upper) : "");
}

}  // namespace

answer::CriticalBracket critical_bracket(const problems::WedgedProblem& problem,
                                         const wedged::CriticalGrid& grid,
                                         const wedged::CriticalFindings& findings) {
  answer::CriticalBracket found{.bracket = findings.bracket,
                                .factor = !problems::uniform_friction(problem),
                                .maximum = grid.maximum,
                                .width = grid.width};
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
                                 const wedged::CriticalGrid& grid,
                                 const wedged::CriticalFindings& findings) {
  const auto bracket = critical_bracket(problem, grid, findings);
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
