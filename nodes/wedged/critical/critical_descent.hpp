// Down from where something wedges to the smallest coefficient: near to it by dives, to few digits
// by a search of all patterns, and to the rest by another. Near the smallest coefficient bounds
// leave little of their trees.
#pragma once

#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_bracket.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Narrows the bracket until it is all that can be told, or the budget is spent. Where nothing is
/// known to wedge it begins at growing coefficients. On all ranks.
/// @param findings its costs and ranks are told, and where it was stopped
void descend(engine::Analysis& analysis, const problems::WedgedProblem& problem,
             const CriticalGrid& grid, Tightening tightening, CriticalBracket& bracket,
             CriticalFindings& findings);

}  // namespace kusabi::wedged
