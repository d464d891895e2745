// Sign patterns that need no search: all candidates of a block in contact, or one whose coefficient
// has a closed form. Of hundreds of candidates a tree may find none for a long time.
#pragma once

#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Those that are alive, of blocks that are not small. Every rank makes the same call and gets the
/// same. @param friction mu of each candidate
std::vector<Configuration> simple_leaves(engine::Analysis& analysis,
                                         const problems::WedgedProblem& problem,
                                         std::span<const double> friction,
                                         const conic::Tolerances& tolerances);

}  // namespace kusabi::wedged
