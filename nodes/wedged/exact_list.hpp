// What other methods find, held against the list of patterns with the exact test: by rays and by
// histories nothing is proved.
#pragma once

#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/rays/ray_search.hpp"
#include "nodes/wedged/sweep/sweep_findings.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// A structure, and how much is to be proved of it.
struct ExactQuestion {
  const problems::Structure& structure;
  const problems::WedgedProblem& problem;
  Proving proving = Proving::automatic;
};

/// Whether the maximal cones that were found are those of the list. Without a need nothing is done.
/// Every rank makes the same call; the answer is that of rank 0. @param found of a whole search
ExactTest tested_cones(engine::Analysis& analysis, const ExactQuestion& question,
                       std::span<const double> friction, const std::vector<rays::Cone>& found);

/// The same of the counts of a sweep: at given points, at the largest coefficient and at both ends
/// of every bracket. What lives at a coefficient lives above it, so where the list is the same at
/// both ends of a step it is so between.
ExactTest tested_counts(engine::Analysis& analysis, const ExactQuestion& question,
                        std::span<const double> points, const SweepFindings& found);

}  // namespace kusabi::wedged
