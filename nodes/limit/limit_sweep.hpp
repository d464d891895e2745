// Worst-case limit load over a range of uncertainties: proved bounds at each alpha, as by
// limit_loads, and all breakpoints of lambda_min between zero and the largest alpha. Analysis of
// `kusabi sweep --alpha`. If the file specifies half-widths of some loads, alpha is that of the
// others, and there are points only.
#pragma once

#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/limit/guaranteed_interval.hpp"
#include "nodes/limit/root/limit_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::limit {

struct LimitSweepPoint {
  double alpha = 0;  ///< in the unit of force
  LimitWorstCase worst;
  GuaranteedInterval interval;
};

struct LimitSweep {
  engine::Status status = engine::Status::solved;  ///< reason of an early end
  std::vector<LimitSweepPoint> points;  ///< of the first of the requested alphas, in their order
  /// At the last alpha: the nominal factor, and at the largest alpha the worst-case curve over beta
  /// from 0 to 1, in multiples of alpha, unless loads have half-widths of their own.
  LimitAnswer last;
  /// The proved claims at each point with their evidence, on rank 0; none unless requested.
  std::vector<std::vector<verify::TrussTheorem>> theorems;

  /// True if all results are complete and proved. @param asked number of alphas
  [[nodiscard]] bool whole(std::size_t asked) const;
};

/// Every rank makes the same call and gets the same result.
/// @param truss for the proofs
/// @param problem of `truss`; not all of its uncertain loads have half-widths of their own
/// @param alphas nonnegative, increasing, in the unit of force; at least one
/// @param evidence true if the claims are required for certificates
LimitSweep sweep_limit_loads(engine::Analysis& analysis, const problems::Structure& truss,
                             const problems::LimitProblem& problem, std::span<const double> alphas,
                             bool evidence = false);

}  // namespace kusabi::limit
