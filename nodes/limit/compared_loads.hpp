// What a worst case is looked at beside: random loads.
#pragma once

#include <optional>
#include <vector>

#include "nodes/limit/model/limit_question.hpp"
#include "nodes/limit/root/root_search.hpp"
#include "nodes/limit/search/zero_one_worst.hpp"

namespace kusabi::limit {

/// What random loads with |zeta|_inf = alpha come to, each from a generator of its own: the same on
/// any number of ranks.
struct SampledLoads {
  std::vector<double> factors;  ///< in the unit of the factor; minus infinity: not carried
  /// The least finite factor, and the collapse at it: v^U of remark 4.5.
  std::optional<ZeroOneStart> best;
};

/// @pre question.alpha
SampledLoads sampled_loads(RootSearch& search, const LimitQuestion& question);

}  // namespace kusabi::limit
