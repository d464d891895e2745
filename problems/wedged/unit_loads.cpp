// Entries of the loads, transferred to the free displacements.
#include "problems/wedged/unit_loads.hpp"

#include <cmath>
#include <vector>

#include "problems/structure/assembly/contact_frame.hpp"
#include "problems/structure/model/elongation.hpp"
#include "problems/structure/model/several_normals.hpp"

namespace kusabi::problems {
namespace {

using numbers::Precise;

/// Bound of the rounding errors of entries of a normal or tangent.
constexpr double frame_roundings = 32;

/// Relative to the sum of the sizes of the entries.
double load_rounding() {
  return frame_roundings * 2 * numbers::unit_roundoff<Precise>;
}

/// Entries of the loads, of which those at the same place are added.
using Entries = std::vector<Eigen::Triplet<Precise>>;

// Adds forces on nodes, transferred to the free displacements and scaled, as the last columns.
void add_node_forces(const FreeDegrees& degrees, const Eigen::MatrixXd& forces,
                     const Eigen::VectorXd& scale, Entries& entries, Eigen::VectorXd& errors) {
  const Eigen::Index d = degrees.number.rows();
  Eigen::Index column = errors.size() - forces.cols();
  for (Eigen::Index load = 0; load < forces.cols(); ++load, ++column) {
    double sizes = 0;
    for (Eigen::Index row = 0; row < forces.rows(); ++row) {
      const double force = forces(row, load);
      if (force == 0) continue;
      for (const auto& part :
           parts_of<Precise>(degrees, static_cast<int>(row % d), static_cast<int>(row / d))) {
        entries.emplace_back(part.number, static_cast<int>(column),
                             part.value * Precise(force) * scale(part.number));
        sizes += std::abs(numbers::rounded(part.value) * force) * scale(part.number);
      }
    }
    errors(column) = load_rounding() * sizes;
  }
}

}  // namespace

numbers::PreciseMatrix Loads::dense(Eigen::Index first, Eigen::Index count) const {
  numbers::PreciseMatrix result = numbers::PreciseMatrix::Zero(matrix.rows(), count);
  for (Eigen::Index column = 0; column < count; ++column) {
    for (Eigen::SparseMatrix<Precise>::InnerIterator entry(matrix, first + column); entry; ++entry)
      result(entry.row(), column) = entry.value();
  }
  return result;
}

Loads unit_loads(const Structure& structure, const FreeDegrees& degrees,
                 const Eigen::MatrixXd& forces, const Eigen::VectorXd& scale) {
  const auto d = static_cast<Eigen::Index>(structure.dimension);
  const auto columns = d * static_cast<Eigen::Index>(structure.contact.size()) + forces.cols();
  Loads loads{Eigen::SparseMatrix<Precise>(degrees.size(), columns), Eigen::VectorXd(columns)};
  Entries entries;
  Eigen::Index column = 0;
  for (const ContactCandidate& candidate : structure.contact) {
    const auto frame = precise_contact_frame(candidate);
    const double sine =
        candidate.tangent ? tangent_sine(candidate.normal, *candidate.tangent) / 2 : 0.5;
    for (Eigen::Index direction = 0; direction < d; ++direction, ++column) {
      double sizes = 0;
      for (int axis = 0; axis < structure.dimension; ++axis) {
        // The displacement is fixed where a roller acts.
        for (const auto& part : candidate_displacement<Precise>(degrees, candidate, axis)) {
          entries.emplace_back(part.number, static_cast<int>(column),
                               part.value * frame(axis, direction) * scale(part.number));
          sizes += std::abs(numbers::rounded(part.value)) * scale(part.number);
        }
      }
      loads.errors(column) = load_rounding() * sizes / (direction == 0 ? 1 : sine);
    }
  }
  add_node_forces(degrees, forces, scale, entries, loads.errors);
  loads.matrix.setFromTriplets(entries.begin(), entries.end());
  return loads;
}

}  // namespace kusabi::problems
