// Detection of mechanisms: motions of a truss without elongation of any member. The paper assumes
// K^0 to be positive definite; other structures are refused, with the names of the nodes that move.
//
// The property depends on the geometry only: with every member stiffness set to one, the stiffness
// is the dimensionless G = sum_e b_e b_e^T, and a mechanism is a vector v with v^T G v = 0. The
// size of EA and ratios of EA have no influence.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// A motion v, |v| = 1, with sum_e (b_e^T v)^2 up to this is a mechanism: each elongation is below
/// 1e-7 of the motion. True mechanisms with coordinates of eight or more digits are below it. A
/// stable truss with the slenderness of 1000 square bays is at about 1e-11. Intermediate cases are
/// detected by the check of the condensed matrices in `wedged_problem`.
inline constexpr double mechanism_tolerance = 1e-14;

/// The nodes that move in a mechanism, in increasing order; empty if the truss is stable. If there
/// are several independent mechanisms, the nodes of all of them.
std::vector<int> moving_nodes(const Structure& structure, const FreeDegrees& degrees);

/// The motion of unit length with the least strain energy, by inverse iteration.
/// @param shifted the stiffness plus a multiple of the unit matrix that makes it definite and is
///        far below all eigenvalues except those of mechanisms
Eigen::VectorXd softest_motion(const Eigen::SparseMatrix<double>& shifted);

/// The nodes whose displacement exceeds a part `visible` of the largest one, in increasing order.
std::vector<int> nodes_moved(const FreeDegrees& degrees, const Eigen::VectorXd& motion,
                             double visible);

/// Names in a message, as in: "a", "b" and 4 more.
std::string some_names(const Structure& structure, const std::vector<int>& nodes);

/// Refuses a structure that is a mechanism.
/// @throws InputError with the names of the nodes that move
void refuse_mechanism(const Structure& structure, const FreeDegrees& degrees);

}  // namespace kusabi::problems
