// Softest motion of a truss by inverse iteration with the slightly shifted G.
#include "problems/structure/bodies/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/factor/sparse_factor.hpp"

namespace kusabi::problems {
namespace {

/// Shift that keeps G + shift I positive definite despite rounding: the diagonal of G is about ten,
/// its rounding error 1e-15.
constexpr double shift = 1e-12;

/// Maximum number of steps of inverse iteration. Each divides the remaining part of a motion with
/// energy e > shift by 1 + e / shift relative to a mechanism, so two or three steps are enough for
/// a mechanism.
constexpr int max_steps = 12;

/// Multiple of the unit matrix added where rounding leaves no factor, relative to the largest
/// diagonal entry, and the number of times that it is raised tenfold.
constexpr double first_lift = 1e-15;
constexpr int max_lifts = 4;

/// A node moves if its displacement exceeds this part of the largest one. The remaining part of
/// other motions after `max_steps` is far smaller.
constexpr double visible = 1e-6;

/// A motion without symmetry, such that every mechanism has a part in it, and equal on all machines
/// (the standard specifies the numbers of mt19937 but not its distributions).
Eigen::VectorXd arbitrary_motion(Eigen::Index size) {
  std::mt19937 bits(1);  // NOLINT(cert-msc32-c,cert-msc51-cpp): repeatable on purpose
  Eigen::VectorXd motion(size);
  for (double& value : motion) value = static_cast<double>(bits()) * 0x1p-32 - 0.5;
  return motion.normalized();
}

/// The stiffness of all elements and springs for unit material.
Eigen::SparseMatrix<double> shape_stiffness(const Structure& structure,
                                            const FreeDegrees& degrees) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Element& element : structure.elements) {
    add_matrix(shape_matrix(structure, element), element_parts<double>(degrees, element), entries);
  }
  for (const Spring& spring : structure.springs) {
    add_square(parts_of<double>(degrees, spring.axis, spring.node), 1.0, entries);
  }
  Eigen::SparseMatrix<double> sum(degrees.size(), degrees.size());
  sum.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

/// Sum of (b^T v)^2 over the vectors b of all elements and springs.
double energy(const Structure& structure, const FreeDegrees& degrees,
              const Eigen::VectorXd& motion) {
  double sum = 0;
  for (const Element& element : structure.elements) {
    for (const auto& vector : shape_vectors(structure, degrees, element)) {
      double strain = 0;
      for (const auto& entry : vector) strain += entry.value * motion(entry.number);
      sum += strain * strain;
    }
  }
  for (const Spring& spring : structure.springs) {
    double strain = 0;
    for (const auto& part : parts_of<double>(degrees, spring.axis, spring.node))
      strain += part.value * motion(part.number);
    sum += strain * strain;
  }
  return sum;
}

/// Maximum number of names in an error message.
constexpr std::size_t max_names = 6;

}  // namespace

std::vector<int> moving_nodes(const Structure& structure, const FreeDegrees& degrees) {
  const auto members = static_cast<Eigen::Index>(structure.members.size());
  Eigen::SparseMatrix<double> shifted =
      truss_stiffness(structure, degrees, Eigen::VectorXd::Ones(members));
  shifted += shape_stiffness(structure, degrees);
  Eigen::SparseMatrix<double> identity(degrees.size(), degrees.size());
  identity.setIdentity();
  shifted += shift * identity;
  const Eigen::VectorXd motion = softest_motion(shifted);
  // The squares of elongations are more accurate than v^T G v.
  const double strain =
      elongations(structure, degrees, motion).squaredNorm() + energy(structure, degrees, motion);
  if (strain > mechanism_tolerance) return {};
  return nodes_moved(degrees, motion, visible);
}

Eigen::VectorXd softest_motion(const Eigen::SparseMatrix<double>& shifted) {
  SparseFactor<double> factor(shifted);
  double lift = first_lift * shifted.diagonal().cwiseAbs().maxCoeff();
  for (int lifted = 0; lifted < max_lifts && !factor.exists(); ++lifted, lift *= 10)
    factor = SparseFactor<double>(shifted, lift);
  if (!factor.exists())
    throw std::logic_error("the shifted stiffness of a structure has no factorisation");
  Eigen::MatrixXd motion = arbitrary_motion(shifted.rows());
  for (int step = 0; step < max_steps; ++step) {
    factor.solve(motion);
    motion.normalize();
  }
  return motion;
}

std::vector<int> nodes_moved(const FreeDegrees& degrees, const Eigen::VectorXd& motion,
                             double visible) {
  const double minimum = visible * motion.cwiseAbs().maxCoeff();
  std::vector<int> nodes;
  for (int number = 0; number < degrees.of_nodes(); ++number) {
    const int node = degrees.free[static_cast<std::size_t>(number)].node;
    if (std::abs(motion(number)) > minimum && (nodes.empty() || nodes.back() != node)) {
      nodes.push_back(node);
    }
  }
  return nodes;
}

std::string some_names(const Structure& structure, const std::vector<int>& nodes) {
  const std::size_t shown = std::min(nodes.size(), max_names);
  std::string list;
  for (std::size_t place = 0; place < shown; ++place) {
    if (place > 0) list += ", ";
    list += quoted_name(structure, nodes[place]);
  }
  if (nodes.size() > shown) list += fmt::format(" and {} more", nodes.size() - shown);
  return list;
}

void refuse_mechanism(const Structure& structure, const FreeDegrees& degrees) {
  const std::vector<int> moving = moving_nodes(structure, degrees);
  if (moving.empty()) return;
  throw structure_error(
      structure, position_of(structure.sources.nodes, moving.front()),
      fmt::format("the structure is a mechanism: {} {} without straining any member; expected "
                  "supports and members that prevent this",
                  some_names(structure, moving), moving.size() == 1 ? "moves" : "move"));
}

}  // namespace kusabi::problems
