// Search of a tree of one block for a state, with bounds of the candidates if the tree is large
// (docs/theory/loads.md, "Bounds and cuts").
#pragma once

#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/hold/hold_record.hpp"
#include "nodes/wedged/hold/hold_search.hpp"
#include "nodes/wedged/hold/load_program.hpp"

namespace kusabi::wedged {

/// Searches a tree until its first leaf. Every rank makes the same call and gets the same result.
/// @param tree loads, friction coefficient and restriction; receives the closed nodes and bounds if
///        `recorded`
/// @param recorded true: without bounds where a certificate cannot have them, unless trees are
///        searched again for the evidence
HoldOutcome search_for_state(engine::Analysis& analysis, const LoadedProblem& block,
                             TreeEvidence& tree, const HoldParameters& parameters, bool recorded);

}  // namespace kusabi::wedged
