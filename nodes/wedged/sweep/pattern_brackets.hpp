// Critical friction coefficients of known patterns: Algorithm 6.1 of the wedged paper, step 2, on
// all ranks.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/friction/critical_pattern_tree.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Finds the cells of all patterns. Every rank makes the same call.
/// @param leaves maximal cones and undecided leaves, the same on all ranks
/// @param start x width: the coefficient at which they were found
engine::Outcome<CriticalPatternTree> bracket_patterns(engine::Analysis& analysis,
                                                      const problems::WedgedProblem& problem,
                                                      const std::vector<Configuration>& leaves,
                                                      CriticalMethod method, double width,
                                                      std::int64_t start);

/// The least coefficient at which a pattern is feasible as it is: a configuration loads exactly its
/// candidates in contact and opens exactly those separated. At a smaller one its leaf may be
/// feasible as a smaller flat pattern, in which more candidates are inactive.
struct PatternBracket {
  double lower = 0;             ///< infeasible here
  std::optional<double> upper;  ///< feasible here; nothing: at no known coefficient
};

/// Brackets of 1e-8 of the coefficient, equal to ConeRange::begins, since both follow from the
/// history of the leaf. Every rank makes the same call.
/// @param leaves on rank 0  @param coefficient at which they were found
/// @returns on rank 0 one for each leaf, in their order; empty if the search was stopped, and on
///          other ranks
std::vector<PatternBracket> pattern_brackets(engine::Analysis& analysis,
                                             const problems::WedgedProblem& problem,
                                             const std::vector<Configuration>& leaves,
                                             double coefficient);

}  // namespace kusabi::wedged
