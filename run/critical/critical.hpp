// `kusabi critical FILE`: the smallest friction coefficient with a wedged configuration, in a
// proved bracket, by one global search or pattern by pattern (Algorithm 6.1 of the wedged paper).
#pragma once

#include <cstdint>
#include <limits>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "answer/verdict.hpp"
#include "engine/options.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"
#include "run/output/terminal_page.hpp"
#include "run/wedged/configuration_files.hpp"

namespace kusabi::run {

struct CriticalOptions {
  ProblemInput input;
  wedged::CriticalParameters parameters;
  std::uint64_t top = std::numeric_limits<std::uint64_t>::max();  ///< maximum number of rows
  bool whole = false;       ///< whole state of every pattern in the result file
  std::string certificate;  ///< certificates of both bounds: NAME.lower and NAME.upper
  engine::Limits limits;    ///< limits of the search
  CheckpointChoice checkpoint;
};

/// Patterns, bracket and costs as text. @param page page of the output
std::string critical_table(const CriticalOptions& options, const problems::WedgedProblem& problem,
                           const wedged::CriticalGrid& grid,
                           const wedged::CriticalFindings& findings, const Page& page);

/// The member `result` of a result file. @param whole of the same structure
nlohmann::ordered_json critical_json(const CriticalOptions& options,
                                     const problems::WedgedProblem& problem,
                                     const wedged::CriticalFindings& findings,
                                     const WholeStateJson& whole);

/// The costs of the searches: its member `statistics`.
nlohmann::ordered_json critical_statistics(const wedged::CriticalFindings& findings);

/// One row per pattern, in the order of the result file.
void write_critical_csv(std::ostream& out, const problems::WedgedProblem& problem,
                        const wedged::CriticalFindings& findings);

answer::CriticalBracket critical_bracket(const problems::WedgedProblem& problem,
                                         const wedged::CriticalGrid& grid,
                                         const wedged::CriticalFindings& findings);

answer::Verdict critical_verdict(const CriticalOptions& options,
                                 const problems::WedgedProblem& problem,
                                 const wedged::CriticalGrid& grid,
                                 const wedged::CriticalFindings& findings);

}  // namespace kusabi::run
