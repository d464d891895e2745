// The critical friction coefficients of patterns that are known: Algorithm 6.1 of the wedged paper,
// step 2, on all ranks.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/friction/bisection.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Searches for the cells of all of them. Every rank makes the same call.
/// @param leaves maximal cones and open leaves, the same on all ranks
/// @param start x width: the coefficient that they were found at
engine::Outcome<PatternBisection> bracket_patterns(engine::Analysis& analysis,
                                                   const problems::WedgedProblem& problem,
                                                   const std::vector<Configuration>& leaves,
                                                   CriticalMethod method, double width,
                                                   std::int64_t start);

/// The least coefficient at which a pattern is feasible as it is: a configuration loads exactly its
/// candidates in contact and opens exactly those separated. At a smaller one its leaf may be
/// feasible as a smaller flat pattern, in which more candidates are inactive.
struct PatternBracket {
  double lower = 0;             ///< infeasible here
  std::optional<double> upper;  ///< feasible here; nothing: not known to be anywhere
};

/// Brackets of 1e-8 of the coefficient: the same as ConeLife::begins, since both are read from the
/// history of the leaf. Every rank makes the same call.
/// @param leaves on rank 0  @param coefficient that they were found at
/// @returns on rank 0 one a leaf, in their order; empty if the search was stopped, and elsewhere
std::vector<PatternBracket> pattern_brackets(engine::Analysis& analysis,
                                             const problems::WedgedProblem& problem,
                                             const std::vector<Configuration>& leaves,
                                             double coefficient);

}  // namespace kusabi::wedged
