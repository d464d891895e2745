// Names of columns and rows of the limit paper's programs in exported files: nodes, axes and
// members as in the problem file.
#pragma once

#include "problems/limit/limit_problem.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::problems {

/// Names of static_program(): q.A-B, lambda; equilibrium.A.x.
void name_static_program(const LimitProblem& problem, linear::LinearProgram& program);

/// Names of kinematic_program(): u.A.x, z.A-B; reference, stretch.A-B, shorten.A-B.
void name_kinematic_program(const LimitProblem& problem, linear::LinearProgram& program);

/// Names of worst_case_program(), in addition: gamma.A.x, tau.A.x; positive.A.x, negative.A.x. A
/// named column of T has its name instead of A.x, with _ for blanks.
void name_worst_case_program(const LimitProblem& problem, linear::LinearProgram& program);

}  // namespace kusabi::problems
