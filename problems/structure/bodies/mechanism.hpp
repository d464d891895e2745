// Whether a truss can move without straining any member. The paper assumes K^0 to be positive
// definite; a structure that is not is refused, with the names of the nodes that move.
//
// That is a question of geometry alone: with every member stiffness set to one, the stiffness is
// G = sum_e b_e b_e^T, without units, and a mechanism is a vector v with v^T G v = 0. So EA of any
// size, or of sizes far apart, changes nothing.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// A motion v, |v| = 1, with sum_e (b_e^T v)^2 up to this strains no member: each elongation is
/// below 1e-7 of the motion. A true mechanism whose coordinates are typed with eight or more digits
/// is below it. A stable truss as slender as 1000 square bays is at 1e-11 or so, well above. What
/// falls in between is caught by the check of the condensed matrices in `wedged_problem`.
inline constexpr double strainless = 1e-14;

/// The nodes that move in a mechanism, in increasing order; empty if the truss is stable. If there
/// are several independent mechanisms, the nodes of all of them.
std::vector<int> moving_nodes(const Structure& structure, const FreeDegrees& degrees);

/// The motion that a stiffness resists least, of length one, found by inverse iteration.
/// @param shifted the stiffness plus a multiple of the unit matrix that makes it definite and is
///        far below all that is not to be found
Eigen::VectorXd softest_motion(const Eigen::SparseMatrix<double>& shifted);

/// The nodes that move by more than a part `visible` of the largest motion, in increasing order.
std::vector<int> nodes_moved(const FreeDegrees& degrees, const Eigen::VectorXd& motion,
                             double visible);

/// "a", "b" and 4 more: enough of them to find the place, and still one line.
std::string some_names(const Structure& structure, const std::vector<int>& nodes);

/// Refuses a structure that is a mechanism.
/// @throws InputError with the names of the nodes that move
void refuse_mechanism(const Structure& structure, const FreeDegrees& degrees);

}  // namespace kusabi::problems
