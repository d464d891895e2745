// The verdict of `kusabi critical`.
#pragma once

#include "answer/verdict.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/critical/critical.hpp"

namespace kusabi::run {

answer::CriticalBracket critical_bracket(const CriticalOptions& options,
                                         const problems::WedgedProblem& problem,
                                         const wedged::CriticalFindings& findings);

answer::Verdict critical_verdict(const CriticalOptions& options,
                                 const problems::WedgedProblem& problem,
                                 const wedged::CriticalFindings& findings);

}  // namespace kusabi::run
