// Stresses in double precision, with the inverse of the Jacobian matrix at the centre of each
// element.
#include "problems/structure/assembly/element_stress.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/LU>

#include "problems/structure/assembly/shape_functions.hpp"
#include "problems/structure/model/element_shape.hpp"

namespace kusabi::problems {
namespace {

NaturalPoint<double> centre_of(const ShapeTraits& traits) {
  NaturalPoint<double> centre{};
  if (traits.family == ShapeFamily::product) return centre;
  if (traits.family == ShapeFamily::pyramid) return {0, 0, -0.75};
  const int axes = traits.family == ShapeFamily::prism ? 2 : traits.dimension;  // of the simplex
  for (std::size_t k = 0; k < static_cast<std::size_t>(axes); ++k) centre[k] = 1.0 / (axes + 1);
  return centre;
}

// d u_k / d x_l at the centre, d x d: (d u / d xi) (d x / d xi)^-1.
Eigen::MatrixXd gradient_at_centre(const Structure& structure, const Element& element,
                                   const Eigen::MatrixXd& displacements) {
  const auto& traits = shape_traits(element.shape);
  const auto slopes = natural_slopes(element.shape, centre_of(traits));
  const Eigen::Index d = traits.dimension;
  const auto first = element.nodes.front();
  Eigen::MatrixXd places = Eigen::MatrixXd::Zero(d, d);
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(d, d);
  // The gradients sum to zero, so displacements and coordinates relative to the first node avoid
  // cancellation.
  for (std::size_t a = 1; a < slopes.size(); ++a) {
    const int node = element.nodes[a];
    const Eigen::RowVectorXd slope = Eigen::Map<const Eigen::RowVectorXd>(slopes[a].data(), d);
    places += (structure.coordinates.col(node) - structure.coordinates.col(first)) * slope;
    motions += (displacements.col(node) - displacements.col(first)) * slope;
  }
  return motions * places.inverse();
}

Eigen::Matrix3d stress_of(const Element& element, const Eigen::MatrixXd& gradient) {
  const Eigen::Index d = gradient.rows();
  const bool thin = d == 2 && element.state == PlaneState::stress;
  const double ratio = element.ratio;
  const double twice_mu = element.modulus / (1 + ratio);
  const double pressure = twice_mu * ratio / (thin ? 1 - ratio : 1 - 2 * ratio) * gradient.trace();
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
  stress.topLeftCorner(d, d) = twice_mu / 2 * (gradient + gradient.transpose());
  stress.diagonal().head(thin ? 2 : 3).array() += pressure;
  return stress;
}

}  // namespace

Stresses element_stresses(const Structure& structure, const Eigen::MatrixXd& displacements) {
  Stresses stresses(6, static_cast<Eigen::Index>(structure.elements.size()));
  Eigen::Index column = 0;
  for (const Element& element : structure.elements) {
    const Eigen::Matrix3d stress =
        stress_of(element, gradient_at_centre(structure, element, displacements));
    stresses.col(column++) << stress.diagonal(), stress(0, 1), stress(1, 2), stress(0, 2);
  }
  return stresses;
}

Eigen::VectorXd von_mises(const Stresses& stresses) {
  Eigen::VectorXd equivalent(stresses.cols());
  for (Eigen::Index i = 0; i < stresses.cols(); ++i) {
    const Eigen::Array3d normal = stresses.col(i).head<3>();
    const double shear = stresses.col(i).tail<3>().squaredNorm();
    equivalent(i) = std::sqrt(1.5 * (normal - normal.mean()).square().sum() + 3 * shear);
  }
  return equivalent;
}

bool has_yield_forces(const Structure& structure) {
  return std::ranges::any_of(structure.members,
                             [](const Member& member) { return member.yield.has_value(); });
}

Eigen::VectorXd utilisations(const Structure& structure, const Eigen::VectorXd& forces) {
  Eigen::VectorXd used =
      Eigen::VectorXd::Constant(forces.size(), std::numeric_limits<double>::quiet_NaN());
  for (Eigen::Index i = 0; i < forces.size(); ++i) {
    const auto& yield = structure.members[static_cast<std::size_t>(i)].yield;
    if (!yield) continue;
    const double strength = forces(i) >= 0 ? yield->tension : yield->compression;
    used(i) = forces(i) == 0 ? 0 : std::abs(forces(i)) / strength;
  }
  return used;
}

}  // namespace kusabi::problems
