// The smallest friction coefficient at which anything can wedge, with a proved bracket, on all
// ranks: by one global search, or pattern by pattern (Algorithm 6.1 of the wedged paper). The
// question that `kusabi critical` asks.
#pragma once

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical_ends.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Finds the bracket and proves its ends. Every rank makes the same call; what was found is
/// complete on rank 0, its status on all.
/// @param structure what the ends are proved of  @param problem of `structure`
/// @param recorder of the evidence of both ends
/// @throws std::invalid_argument if a coefficient or the width is out of range
CriticalFindings find_critical_friction(engine::Analysis& analysis,
                                        const problems::Structure& structure,
                                        const problems::WedgedProblem& problem,
                                        const CriticalQuestion& question,
                                        const EndRecorder& recorder = {});

}  // namespace kusabi::wedged
