// Bounds of motions whose value is at most that of a known collapse, for a safe M of (29).
//
// If the relaxation with yield forces (1 - rho) q^y has a bound L, then every motion u has a value
// of at least L + rho q^y'|B'u|; so one of value at most U dissipates q^y'|B'u| <= D = (U - L) /
// rho. Then |b_i'u| <= D / q^y_i, and by a static cut |d_j'u| <= D max_i |y_i| / q^y_i + |k|.
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "nodes/limit/model/static_cut.hpp"
#include "problems/limit/limit_analysis.hpp"

namespace kusabi::limit {

struct MotionBounds {
  Eigen::VectorXd motion;      ///< of |d_j'u| for the columns of T: m
  Eigen::VectorXd elongation;  ///< of |b_i'u|, n^m
};

/// @param alpha scaled
/// @param cuts at least one for each column of T
/// @param upper U: the value of a known collapse
/// @return nothing if no tested rho gives a bound
std::optional<MotionBounds> motion_bounds(const problems::LimitModel& model, double alpha,
                                          std::span<const StaticCut> cuts, double upper);

}  // namespace kusabi::limit
