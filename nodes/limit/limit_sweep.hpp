// The worst-case limit load over a range of uncertainties: at each of some alphas with both ends
// proved, as by limit_loads, and all breakpoints of lambda_min between zero and the largest. The
// question that `kusabi sweep --alpha` asks. Where the file says how far some loads go, alpha is
// that of the others, and there are points only.
#pragma once

#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/limit/guaranteed_interval.hpp"
#include "nodes/limit/root/limit_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::limit {

struct LimitSweepPoint {
  double alpha = 0;  ///< in the unit of force
  LimitWorstCase worst;
  GuaranteedInterval interval;
};

struct LimitSweep {
  engine::Status status = engine::Status::solved;  ///< why it ended before it was done
  std::vector<LimitSweepPoint> points;             ///< of those asked for the first, in their order
  /// At the last one that was looked at: the nominal factor, and at the largest of all the worst
  /// curve, over beta from 0 to 1, in multiples of the largest, unless loads have half-widths of
  /// their own.
  LimitAnswer last;

  /// Whether all that was asked for is answered and proved. @param asked how many alphas
  [[nodiscard]] bool whole(std::size_t asked) const;
};

/// Every rank makes the same call, and all come to the same.
/// @param truss what the ends are proved of @param problem of `truss`; not all of its uncertain
///        loads have half-widths of their own
/// @param alphas not negative, increasing, in the unit of force; at least one
LimitSweep sweep_limit_loads(engine::Analysis& analysis, const problems::Structure& truss,
                             const problems::LimitProblem& problem, std::span<const double> alphas);

}  // namespace kusabi::limit
