// Safe M of the 0-1 program (29) of the limit paper in the units of the problem, for exported
// files.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "engine/analysis/analysis.hpp"
#include "problems/limit/limit_problem.hpp"

namespace kusabi::limit {

/// Twice a bound of each gamma_j (motion_bounds.hpp), by static cuts on all ranks; the same on
/// each.
/// @param alpha in the unit of force, above 0
/// @return m; nothing if no bound is found, or if the nominal load has no load factor
std::optional<Eigen::VectorXd> safe_big_m(engine::Analysis& analysis,
                                          const problems::LimitProblem& problem, double alpha);

}  // namespace kusabi::limit
