// The model in the unit of force of its own collapse: yield forces of a truss may span twelve
// decades, and only those of the order of what collapses matter to the last digit.
#pragma once

#include <optional>

#include "problems/limit/limit_analysis.hpp"

namespace kusabi::limit {

/// The model in which the nominal collapse dissipates about one, or the loads are about one if that
/// is less: what they strain must not be cut off. If the nominal load is carried at no factor, or
/// the simplex method fails: in the median of the yield forces.
/// @param alpha half the width of the uncertain components, in the unit of force
problems::LimitModel balanced_model(const problems::LimitProblem& problem, double alpha);

/// The same about a dissipation that is known, scaled as in `model`.
problems::LimitModel rebalanced(const problems::LimitProblem& problem,
                                const problems::LimitModel& model, double dissipation,
                                double alpha);

/// The same with yield forces cut off much higher; nothing if none is cut off.
std::optional<problems::LimitModel> with_more_yield(const problems::LimitProblem& problem,
                                                    const problems::LimitModel& model);

/// q^y'|B'u| of a motion, with the true yield forces: scaled as in `model`, which may have some cut
/// off.
double dissipation(const problems::LimitProblem& problem, const problems::LimitModel& model,
                   const Eigen::VectorXd& motion);

/// Whether scaled numbers are too far from one to be trusted to a simplex method.
bool is_out_of_balance(double dissipation);

}  // namespace kusabi::limit
