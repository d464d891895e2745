// Names for the columns and rows of the limit paper's programs, in files that others read: nodes,
// axes and members as the problem file calls them.
#pragma once

#include "problems/limit/limit_problem.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::problems {

/// Of static_program(): q.A-B, lambda; equilibrium.A.x.
void name_static_program(const LimitProblem& problem, linear::LinearProgram& program);

/// Of kinematic_program(): u.A.x, z.A-B; reference, stretch.A-B, shorten.A-B.
void name_kinematic_program(const LimitProblem& problem, linear::LinearProgram& program);

/// Of worst_case_program(), besides these: gamma.A.x, tau.A.x; positive.A.x, negative.A.x. A column
/// of T with a name has that in the place of A.x, with _ for blanks.
void name_worst_case_program(const LimitProblem& problem, linear::LinearProgram& program);

}  // namespace kusabi::problems
