// Curves of load factors over beta (limit paper, remark 3.3 and Figure 5): a load that grows in
// proportion, and the worst case as the uncertainty grows.
//
// The latter is concave, too: it is the least of the curves of all corners of the uncertain loads,
// each of which is concave. So one proof at each breakpoint proves it everywhere: between two of
// them it is no lower than the line through what is proved there, and no higher than the line of
// the mode, which the same kinematic certificate shows at both.
#pragma once

#include <Eigen/Core>

#include "nodes/limit/model/load_curve.hpp"
#include "nodes/limit/root/root_search.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

/// lambda*(f_D + beta g) over beta from 0 to `to`, in the units of the problem, as the simplex
/// method finds it. Every rank computes it alike.
/// @param load g, n^d, force
LoadCurve factor_curve(RootSearch& search, const Eigen::VectorXd& load, double to);

/// lambda_min(beta alpha), likewise; every rank makes the same call, and each place is proved.
/// @param alpha in the unit of force @param truss what the proofs are of
LoadCurve worst_factor_curve(RootSearch& search, const verify::Structure& truss, double alpha,
                             double to);

}  // namespace kusabi::limit
