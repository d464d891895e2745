// Descent from a feasible coefficient to the smallest one: first dives, then a search of all
// patterns to two digits, then a search to full accuracy. Near the smallest coefficient candidate
// bounds exclude most of the trees.
#pragma once

#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical/narrowing_bracket.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Narrows the bracket as far as possible within the budget. If no feasible coefficient is known it
/// starts at increasing ones. Called on all ranks.
/// @param findings receive costs, rank reports and the phase in which the run was stopped
void descend(engine::Analysis& analysis, const problems::WedgedProblem& problem,
             const CriticalGrid& grid, Tightening tightening, NarrowingBracket& bracket,
             CriticalFindings& findings);

}  // namespace kusabi::wedged
