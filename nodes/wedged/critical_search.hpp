// Smallest friction coefficient at which a configuration is wedged, with a proved bracket, on all
// ranks: by a global search, or for each pattern (Algorithm 6.1 of the wedged paper). Analysis of
// `kusabi critical`.
#pragma once

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical_bounds.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Finds the bracket and proves its bounds. Every rank makes the same call; the result is complete
/// on rank 0, its status on all.
/// @param structure for the proofs  @param problem of `structure`
/// @param recorder of the evidence of both bounds
/// @throws std::invalid_argument if a coefficient or the width is out of range
CriticalFindings find_critical_friction(engine::Analysis& analysis,
                                        const problems::CheckedStructure& structure,
                                        const problems::WedgedProblem& problem,
                                        const CriticalParameters& parameters,
                                        const BoundRecorder& recorder = {});

}  // namespace kusabi::wedged
