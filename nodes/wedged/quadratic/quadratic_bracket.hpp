// The lower bound of the critical coefficient by quadratic forms, one for each block.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical/narrowing_bracket.hpp"
#include "nodes/wedged/quadratic/quadratic_optimiser.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Trees of smaller problems need no other lower bound.
inline constexpr int min_candidates_for_forms = 48;

/// Forms that hold at one coefficient.
struct QuadraticForms {
  double factor = 0;                           ///< 0: there are none
  std::vector<std::vector<double>> numbers{};  ///< of each block: QuadraticMultipliers::numbers()
  std::uint64_t evaluations = 0;
};

/// Forms of all blocks at the least of their coefficients; none if that is not above the lower
/// bound of the bracket. On all ranks.
/// @param rounds of the optimisation: QuadraticParameters::rounds
QuadraticForms quadratic_forms(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                               const CriticalGrid& grid, const NarrowingBracket& bracket,
                               int rounds);

}  // namespace kusabi::wedged
