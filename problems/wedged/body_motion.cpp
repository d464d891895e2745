// Coefficients of the modes of all bodies by a decomposition of their displacements.
#include "problems/wedged/body_motion.hpp"

#include <Eigen/QR>

#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/wedged/contact_motions.hpp"

namespace kusabi::problems {
namespace {

/// A body with smaller velocities, beside the largest, counts as at rest.
constexpr double at_rest = 1e-3;

/// Modes of bodies count as dependent below this share of the largest pivot.
constexpr double dependent_modes = 1e-10;

}  // namespace

BodyMotion body_motion(const CheckedStructure& structure, const Eigen::VectorXd& displacements) {
  const auto& bodies = structure.unconstrained_bodies();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> modes;
  modes.setThreshold(dependent_modes);
  modes.compute(restricted_modes(*structure, bodies).cast<double>());
  Eigen::VectorXd amounts = modes.solve(displacements);
  BodyMotion motion{
      .only_body = bodies.size() == 1,
      .velocities = Eigen::MatrixXd::Zero(structure->dimension, structure->coordinates.cols())};
  const auto each = [&](const auto& visit) {
    Eigen::Index first = 0;
    for (const auto& body : bodies) {
      visit(body, amounts.segment(first, body.count()));
      first += body.count();
    }
  };
  each([&](const UnconstrainedBody& body, const auto& own) {
    for (const int node : body.nodes)
      motion.velocities.col(node) =
          problems::displacements(body, structure->coordinates.col(node)).cast<double>() * own;
  });
  motion.largest = motion.velocities.cwiseAbs().maxCoeff();
  if (!(motion.largest > 0)) return motion;
  motion.velocities /= motion.largest;
  amounts /= motion.largest;
  each([&](const UnconstrainedBody& body, const auto& own) {
    const Eigen::VectorXd velocity = body.motions.cast<double>() * own;
    if (velocity.cwiseAbs().maxCoeff() > at_rest)
      motion.bodies.push_back({structure->node_names[static_cast<std::size_t>(body.nodes.front())],
                               described(*structure, body, velocity)});
  });
  return motion;
}

}  // namespace kusabi::problems
