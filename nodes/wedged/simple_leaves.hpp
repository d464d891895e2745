// Sign patterns found without a search: all candidates of a block in contact, or a single one,
// whose coefficient has a closed form. A tree with hundreds of candidates may find no pattern for a
// long time.
#pragma once

#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// The feasible patterns of this kind; small blocks are left out. Every rank makes the same call
/// and gets the same result. @param friction mu of each candidate
std::vector<Configuration> simple_leaves(engine::Analysis& analysis,
                                         const problems::WedgedProblem& problem,
                                         std::span<const double> friction,
                                         const conic::Tolerances& tolerances);

}  // namespace kusabi::wedged
