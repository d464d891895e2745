// What a worst case is looked at beside: random loads, and how the factor falls as loads grow.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "nodes/limit/limit_question.hpp"
#include "nodes/limit/load_curve.hpp"
#include "nodes/limit/root_search.hpp"

namespace kusabi::limit {

/// The factors of random loads with |zeta|_inf = alpha, each from a generator of its own: the same
/// on any number of ranks. Minus infinity: not carried. @pre question.alpha
std::vector<double> sampled_factors(RootSearch& search, const LimitQuestion& question);

/// lambda*(f_D + beta T zeta) over beta from 0 to 1, in the units of the problem; nothing if the
/// load is not carried somewhere. @param zeta in the unit of force
std::vector<CurvePiece> factor_curve(RootSearch& search, const Eigen::VectorXd& zeta);

/// lambda_min(beta alpha), likewise. @param alpha in the unit of force
std::vector<CurvePiece> worst_factor_curve(RootSearch& search, double alpha);

}  // namespace kusabi::limit
