// Model in the unit of force of its own collapse. Yield forces of a truss may span twelve decades,
// and only those of the order of the collapse matter to the last digit.
#pragma once

#include <optional>

#include "problems/limit/limit_analysis.hpp"

namespace kusabi::limit {

/// The model in which the dissipation of the nominal collapse is about one, or the loads are about
/// one if that is smaller, so that the yield forces they need are not truncated. If the nominal
/// load has no factor, or the simplex method fails, the unit is the median of the yield forces.
/// @param alpha half-width of the uncertain components, in the unit of force
problems::LimitModel balanced_model(const problems::LimitProblem& problem, double alpha);

/// The same for a known dissipation, scaled as in `model`.
problems::LimitModel rebalanced(const problems::LimitProblem& problem,
                                const problems::LimitModel& model, double dissipation,
                                double alpha);

/// The same with much larger limits of yield forces; nothing if none is truncated.
std::optional<problems::LimitModel> with_more_yield(const problems::LimitProblem& problem,
                                                    const problems::LimitModel& model);

/// q^y'|B'u| of a motion with untruncated yield forces, scaled as in `model`.
double dissipation(const problems::LimitProblem& problem, const problems::LimitModel& model,
                   const Eigen::VectorXd& motion);

/// True if the scaled numbers are too far from one for the simplex method.
bool is_out_of_balance(double dissipation);

}  // namespace kusabi::limit
