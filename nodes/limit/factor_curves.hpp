// Curves of load factors over beta (limit paper, remark 3.3 and Figure 5): a load that grows in
// proportion, and the worst case with growing uncertainty.
//
// The latter is concave, too: it is the minimum of the curves of all vertices of the uncertain
// loads, each of which is concave. One proof at each breakpoint therefore proves it everywhere:
// between two of them it is not below the chord of the proved lower bounds, and not above the line
// of the mode, which the same kinematic certificate proves at both.
#pragma once

#include <Eigen/Core>

#include "nodes/limit/model/load_curve.hpp"
#include "nodes/limit/root/root_search.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

/// lambda*(f_D + beta g) over beta from 0 to `to`, in the units of the problem, by the simplex
/// method. Every rank computes the same.
/// @param load g, n^d, force
LoadCurve factor_curve(RootSearch& search, const Eigen::VectorXd& load, double to);

/// lambda_min(beta alpha), likewise; every rank makes the same call, and each point is proved.
/// @param alpha in the unit of force @param truss for the proofs
LoadCurve worst_factor_curve(RootSearch& search, const verify::Structure& truss, double alpha,
                             double to);

}  // namespace kusabi::limit
