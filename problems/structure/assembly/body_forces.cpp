// Sums over the integration points, and products with element matrices, in doubles.
#include "problems/structure/assembly/body_forces.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "problems/structure/assembly/shape_functions.hpp"
#include "problems/structure/assembly/solid_element.hpp"

namespace kusabi::problems {
namespace {

/// Abscissas from 0 to 1 and weights of Gauss' rule of degree 5.
const std::array<std::pair<double, double>, 3> gauss{
    {{0.5 - std::sqrt(0.15), 5.0 / 18}, {0.5, 4.0 / 9}, {0.5 + std::sqrt(0.15), 5.0 / 18}}};

/// Values of the shape functions: their slopes, of degree 4 or less, integrated along the line from
/// the first node.
Eigen::VectorXd shape_values(ElementShape shape, const NaturalPoint<double>& at) {
  const auto& traits = shape_traits(shape);
  const auto d = static_cast<std::size_t>(traits.dimension);
  const auto& first = traits.nodes.front();
  Eigen::VectorXd values = Eigen::VectorXd::Unit(static_cast<Eigen::Index>(traits.nodes.size()), 0);
  for (const auto& [part, weight] : gauss) {
    NaturalPoint<double> between{};
    for (std::size_t k = 0; k < d; ++k) between[k] = first[k] + part * (at[k] - first[k]);
    const auto slopes = natural_slopes(shape, between);
    for (std::size_t a = 0; a < slopes.size(); ++a) {
      for (std::size_t k = 0; k < d; ++k)
        values[static_cast<Eigen::Index>(a)] += weight * slopes[a][k] * (at[k] - first[k]);
    }
  }
  return values;
}

/// An integration point: its volume, the values of the shape functions, and their gradients, d x
/// nodes.
struct VolumePoint {
  double volume;
  Eigen::VectorXd values;
  Eigen::MatrixXd gradients;
};

std::vector<VolumePoint> volume_points(const Structure& structure, const Element& element) {
  const auto d = static_cast<Eigen::Index>(structure.dimension);
  const auto size = static_cast<Eigen::Index>(element.nodes.size());
  const Eigen::MatrixXd places = structure.coordinates(Eigen::all, element.nodes);
  const double thickness = d == 2 ? element.thickness : 1;
  std::vector<VolumePoint> points;
  for (const auto& point : integration_points<double>(element.shape)) {
    Eigen::MatrixXd slopes(d, size);
    for (Eigen::Index a = 0; a < size; ++a) {
      for (Eigen::Index k = 0; k < d; ++k)
        slopes(k, a) = point.slopes[static_cast<std::size_t>(a)][static_cast<std::size_t>(k)];
    }
    const Eigen::MatrixXd jacobian = slopes * (places.colwise() - places.col(0)).transpose();
    points.push_back({point.weight * std::abs(jacobian.determinant()) * thickness,
                      shape_values(element.shape, point.at), jacobian.inverse() * slopes});
  }
  return points;
}

Eigen::MatrixXd no_forces(const Structure& structure) {
  return Eigen::MatrixXd::Zero(structure.dimension, structure.coordinates.cols());
}

/// Pressure in an element that is prevented from expanding.
double thermal_pressure(const Structure& structure, const Element& element, double rise) {
  const bool thin = structure.dimension == 2 && element.state == PlaneState::stress;
  const double room = thin ? 1 - element.ratio : 1 - 2 * element.ratio;
  return element.modulus * element.expansion * rise / room;
}

}  // namespace

Eigen::MatrixXd weight(const Structure& structure, const Eigen::VectorXd& gravity) {
  Eigen::MatrixXd forces = no_forces(structure);
  for (const Member& bar : structure.members) {
    const Eigen::VectorXd own =
        bar.mass / 2 * extent<double>(structure, bar).stableNorm() * gravity;
    forces.col(bar.first) += own;
    forces.col(bar.second) += own;
  }
  for (const Element& element : structure.elements) {
    if (element.density == 0) continue;
    for (const auto& point : volume_points(structure, element)) {
      for (std::size_t a = 0; a < element.nodes.size(); ++a)
        forces.col(element.nodes[a]) +=
            element.density * point.volume * point.values[static_cast<Eigen::Index>(a)] * gravity;
    }
  }
  return forces;
}

Eigen::MatrixXd forces_of_temperature(const Structure& structure, double rise) {
  Eigen::MatrixXd forces = no_forces(structure);
  for (const Member& bar : structure.members) {
    const Eigen::VectorXd along = extent<double>(structure, bar).stableNormalized();
    forces.col(bar.first) -= bar.axial_stiffness * bar.expansion * rise * along;
    forces.col(bar.second) += bar.axial_stiffness * bar.expansion * rise * along;
  }
  for (const Element& element : structure.elements) {
    if (element.expansion == 0) continue;
    const double pressure = thermal_pressure(structure, element, rise);
    for (const auto& point : volume_points(structure, element)) {
      for (std::size_t a = 0; a < element.nodes.size(); ++a)
        forces.col(element.nodes[a]) +=
            pressure * point.volume * point.gradients.col(static_cast<Eigen::Index>(a));
    }
  }
  return forces;
}

Eigen::MatrixXd forces_of_displaced(const Structure& structure,
                                    const std::map<int, Eigen::VectorXd>& displaced) {
  Eigen::MatrixXd forces = no_forces(structure);
  const auto d = static_cast<Eigen::Index>(structure.dimension);
  const auto of = [&](int node) -> Eigen::VectorXd {
    const auto found = displaced.find(node);
    return found == displaced.end() ? Eigen::VectorXd::Zero(d) : found->second;
  };
  for (const Member& bar : structure.members) {
    const Eigen::VectorXd along = extent<double>(structure, bar).stableNormalized();
    const double tension =
        bar_stiffness<double>(structure, bar) * along.dot(of(bar.second) - of(bar.first));
    forces.col(bar.first) += tension * along;
    forces.col(bar.second) -= tension * along;
  }
  for (const Element& element : structure.elements) {
    Eigen::VectorXd own(d * static_cast<Eigen::Index>(element.nodes.size()));
    for (std::size_t a = 0; a < element.nodes.size(); ++a)
      own.segment(d * static_cast<Eigen::Index>(a), d) = of(element.nodes[a]);
    if (own.isZero(0)) continue;
    const Eigen::VectorXd held = element_matrix<double>(structure, element) * own;
    for (std::size_t a = 0; a < element.nodes.size(); ++a)
      forces.col(element.nodes[a]) -= held.segment(d * static_cast<Eigen::Index>(a), d);
  }
  return forces;
}

}  // namespace kusabi::problems
