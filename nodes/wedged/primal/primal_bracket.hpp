// The upper bound of the critical coefficient by patterns that are found without a tree.
#pragma once

#include <cstdint>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_bracket.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Searches the blocks one after another and lowers the upper bound with each better pattern, at
/// last to the cell of the grid that the best one begins in. On all ranks.
/// @return programs solved
std::uint64_t sink_by_patterns(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                               const CriticalGrid& grid, CriticalBracket& bracket);

}  // namespace kusabi::wedged
