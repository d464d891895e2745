// Resolution of objectives: steps of about 1e-9 of their own size. Otherwise the search would
// enumerate all optima that are equal up to rounding. The step depends on the objective itself
// alone: a cost depends on the unit of its column, and the first point found may contain a penalty
// of 1e12. Zero has no size, and is equal to zero only.
#pragma once

#include <cmath>

namespace kusabi::zero_one {

/// Width of the step around a finite objective: a power of two, 2^-30 of its size or somewhat more
/// than half of that; 0 for zero.
inline double step_width(double objective) {
  constexpr int bits = 30;
  return objective == 0 ? 0 : std::ldexp(1.0, std::ilogb(objective) - bits);
}

/// The objective in whole steps; rounding keeps the order of two objectives.
inline double in_steps(double objective) {
  const double step = std::isfinite(objective) ? step_width(objective) : 0;
  return step == 0 ? objective : std::round(objective / step) * step;
}

}  // namespace kusabi::zero_one
