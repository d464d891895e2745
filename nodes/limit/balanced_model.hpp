// The model in the unit of force of its own collapse: yield forces of a truss may span twelve
// decades, and only those of the order of what collapses matter to the last digit.
#pragma once

#include "problems/limit_analysis.hpp"

namespace kusabi::nodes::limit {

/// The model in which the nominal collapse dissipates about one. If the nominal load is carried at
/// no factor, or the simplex method fails: in the median of the yield forces.
problems::LimitModel balanced_model(const problems::LimitProblem& problem);

/// The same about a dissipation that is known, scaled as in `model`.
problems::LimitModel rebalanced(const problems::LimitProblem& problem,
                                const problems::LimitModel& model, double dissipation);

/// q^y'|B'u| of a motion, with the true yield forces: scaled as in `model`, which may have some cut
/// off.
double dissipation(const problems::LimitProblem& problem, const problems::LimitModel& model,
                   const Eigen::VectorXd& motion);

/// Whether scaled numbers are too far from one to be trusted to a simplex method.
bool is_out_of_balance(double dissipation);

}  // namespace kusabi::nodes::limit
