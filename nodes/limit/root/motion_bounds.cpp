// The least D of several values of rho.
#include "nodes/limit/root/motion_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "nodes/limit/root/master.hpp"

namespace kusabi::limit {
namespace {

/// Relative increase of the bounds: the simplex method's L is accurate to about 1e-9, and a
/// slightly larger M has no cost.
constexpr double widened = 1e-6;

}  // namespace

std::optional<MotionBounds> motion_bounds(const problems::LimitModel& model, double alpha,
                                          std::span<const StaticCut> cuts, double upper) {
  const Eigen::VectorXd yield = model.yield();
  Master master(model, alpha);
  for (const StaticCut& cut : cuts) master.add(cut);
  double maximum = linear::infinity;  // D
  for (const double rho : {0.5, 0.3, 0.1, 0.03, 0.01, 0.003, 0.001}) {
    master.reduce_yield_forces(rho * yield);
    if (!master.solve() || master.box_is_active()) continue;
    maximum = std::min(maximum, (upper - master.objective()) / rho);
  }
  if (!std::isfinite(maximum)) return {};
  maximum = maximum * (1 + widened) + widened;
  MotionBounds bounds;
  bounds.elongation = maximum * yield.cwiseInverse();
  bounds.motion.setConstant(model.uncertain_count(), linear::infinity);
  for (const StaticCut& cut : cuts) {
    double largest = 0;
    for (const auto& [member, force] : cut.forces) {
      largest = std::max(largest, std::abs(force) / yield(member));
    }
    double& bound = bounds.motion(cut.column);
    bound = std::min(bound, maximum * largest + std::abs(cut.factor) + widened);
  }
  return bounds;
}

}  // namespace kusabi::limit
