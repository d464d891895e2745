// Random loads for comparison with the worst case.
#pragma once

#include <optional>
#include <vector>

#include "nodes/limit/model/limit_parameters.hpp"
#include "nodes/limit/root/root_search.hpp"
#include "nodes/limit/search/zero_one_worst.hpp"

namespace kusabi::limit {

/// Factors of random loads with |zeta|_inf = alpha, each from a generator of its own: the same on
/// any number of ranks.
struct SampledLoads {
  std::vector<double> factors;  ///< in the unit of the factor; minus infinity: no factor
  /// The least finite factor, and its collapse: v^U of remark 4.5.
  std::optional<ZeroOneStart> best;
};

/// @pre parameters.alpha
SampledLoads sampled_loads(RootSearch& search, const LimitParameters& parameters);

}  // namespace kusabi::limit
