// The verdict of `kusabi critical`.
#pragma once

#include "nodes/wedged/critical/critical_findings.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/critical/critical.hpp"
#include "run/verdict/verdict.hpp"

namespace kusabi::run {

CriticalBracket critical_bracket(const CriticalOptions& options,
                                 const problems::WedgedProblem& problem,
                                 const wedged::CriticalFindings& findings);

Verdict critical_verdict(const CriticalOptions& options, const problems::WedgedProblem& problem,
                         const wedged::CriticalFindings& findings);

}  // namespace kusabi::run
