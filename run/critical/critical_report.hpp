// Results of `kusabi critical`: the table and the JSON.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "nodes/wedged/critical/critical_findings.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/critical/critical.hpp"
#include "run/output/terminal_page.hpp"
#include "run/wedged/whole_state_json.hpp"

namespace kusabi::run {

/// Patterns, bracket and costs as text. @param page page of the output
std::string critical_table(const CriticalOptions& options, const problems::WedgedProblem& problem,
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

}  // namespace kusabi::run
