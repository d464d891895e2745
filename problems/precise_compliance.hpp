// The compliance F = K^-1 of the contact candidates with more digits than a double has.
//
// Which extremal rays there are hangs on sums of its entries that vanish exactly, or only almost,
// and along a row of candidates the entries fall by orders of magnitude. Entries that are right to
// 1e-16 of the largest are not enough to tell the two apart from some dozen candidates on.
#pragma once

#include <Eigen/Core>

#include "problems/structure.hpp"

namespace kusabi::problems {

using PreciseMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// F, dm x dm, ordered as in WedgedProblem, length/force: assembled and factorised in extended
/// precision from the coordinates and stiffnesses of the structure, which count as exact.
/// @pre `wedged_problem` accepts the structure
PreciseMatrix precise_compliance(const Structure& structure);

}  // namespace kusabi::problems
