// K without the grounding springs of unconstrained bodies.
#pragma once

#include <Eigen/Core>

#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::problems {

/// K of equation (6), dm x dm, exactly symmetric. With unconstrained bodies it is semidefinite, K G
/// = 0 up to rounding; otherwise it is the stiffness of the problem.
Eigen::MatrixXd free_stiffness(const WedgedProblem& problem);

}  // namespace kusabi::problems
