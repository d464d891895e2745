// Upper bound of the critical coefficient by the primal heuristic.
#pragma once

#include <cstdint>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical/narrowing_bracket.hpp"
#include "nodes/wedged/primal/primal_search.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Decreases the upper bound with each better pattern, one block after another, and finally to the
/// cell of the grid in which the best pattern becomes feasible. On all ranks.
/// @return number of cone programs solved; 0 if no block has this part
std::uint64_t reduce_by_patterns(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                                 const CriticalGrid& grid, PrimalPart part,
                                 NarrowingBracket& bracket);

}  // namespace kusabi::wedged
