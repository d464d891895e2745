// What a worst case is looked at beside: random loads.
#pragma once

#include <vector>

#include "nodes/limit/limit_question.hpp"
#include "nodes/limit/root_search.hpp"

namespace kusabi::limit {

/// The factors of random loads with |zeta|_inf = alpha, each from a generator of its own: the same
/// on any number of ranks. Minus infinity: not carried. @pre question.alpha
std::vector<double> sampled_factors(RootSearch& search, const LimitQuestion& question);

}  // namespace kusabi::limit
