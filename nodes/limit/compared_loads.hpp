// What a worst case is looked at beside: random loads, and how the factor falls as loads grow.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "nodes/limit/limit_question.hpp"
#include "nodes/limit/load_curve.hpp"
#include "nodes/limit/root_search.hpp"
#include "nodes/limit/zero_one_worst.hpp"

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

/// lambda*(f_D + beta T zeta) over beta from 0 to 1, in the units of the problem; nothing if the
/// load is not carried somewhere. @param zeta in the unit of force
std::vector<CurvePiece> factor_curve(RootSearch& search, const Eigen::VectorXd& zeta);

/// lambda_min(beta alpha), likewise. @param alpha in the unit of force
std::vector<CurvePiece> worst_factor_curve(RootSearch& search, double alpha);

}  // namespace kusabi::limit
