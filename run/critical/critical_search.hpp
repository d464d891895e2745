// The bracket of the critical friction coefficient, by one global search or pattern by pattern.
#pragma once

#include "engine/budget.hpp"
#include "engine/options.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/critical/critical.hpp"
#include "run/critical/critical_report.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// How far the global search looks unless told: obstacles are not rougher.
inline constexpr double usual_most = 1000;

/// Searches on all ranks. What was found is complete on rank 0 only, but for its status.
CriticalFindings global_search(Session& session, const CriticalOptions& options,
                               const problems::WedgedProblem& problem,
                               const engine::Budget& budget);
CriticalFindings pattern_by_pattern(Session& session, const CriticalOptions& options,
                                    const problems::WedgedProblem& problem,
                                    const engine::Budget& budget);

}  // namespace kusabi::run
