// K without the temporary springs of loose bodies.
#pragma once

#include <Eigen/Core>

#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::problems {

/// K of equation (6), dm x dm, exactly symmetric: with loose bodies only semidefinite, K G = 0 up
/// to rounding. Without, the stiffness of the problem.
Eigen::MatrixXd free_stiffness(const WedgedProblem& problem);

}  // namespace kusabi::problems
