// Friction coefficient from which a pattern is feasible, to the few digits that a comparison of
// patterns requires.
#pragma once

#include <limits>
#include <optional>

#include "nodes/wedged/friction/critical_friction.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// The range that is searched.
struct CoefficientRange {
  double infeasible = 0;  ///< no pattern is feasible up to this coefficient
  double first = 1;       ///< coefficient that is tried first if there is no limit
  double limit = std::numeric_limits<double>::infinity();  ///< none above is of interest
};

/// A coefficient at which the pattern with these candidates in contact and all others separated is
/// feasible by its program, near the smallest such; nothing if there is none in the range.
std::optional<double> pattern_coefficient(CriticalFriction& critical,
                                          const support::IndexSet& contact,
                                          const CoefficientRange& range);

}  // namespace kusabi::wedged
