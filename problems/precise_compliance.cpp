// Assembly and solution in extended precision.
#include "problems/precise_compliance.hpp"

#include <cstddef>
#include <stdexcept>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "problems/contact_frame.hpp"
#include "problems/elongation.hpp"
#include "problems/quadrilateral.hpp"
#include "problems/truss.hpp"

namespace kusabi::problems {
namespace {

using Real = long double;
using SparseMatrix = Eigen::SparseMatrix<Real>;

SparseMatrix stiffness(const Structure& structure, const FreeDegrees& degrees) {
  std::vector<Eigen::Triplet<Real>> entries;
  for (const Member& member : structure.members) {
    const Real length = extent<Real>(structure, member).stableNorm();
    add_square(elongation_vector<Real>(structure, degrees, member),
               Real(member.axial_stiffness) / length, entries);
  }
  for (const Quadrilateral& element : structure.elements) {
    for (const auto& vector : strain_vectors<Real>(structure, degrees, element)) {
      add_square(vector, Real(1), entries);
    }
  }
  SparseMatrix result(degrees.size(), degrees.size());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// The directions of all candidates as loads, f x dm: column by column n, t1[, t2].
PreciseMatrix unit_loads(const Structure& structure, const FreeDegrees& degrees) {
  const auto d = static_cast<Eigen::Index>(structure.dimension);
  PreciseMatrix loads =
      PreciseMatrix::Zero(degrees.size(), d * static_cast<Eigen::Index>(structure.contact.size()));
  Eigen::Index column = 0;
  for (const ContactCandidate& candidate : structure.contact) {
    const Eigen::MatrixXd frame = contact_frame(candidate);
    for (Eigen::Index direction = 0; direction < d; ++direction, ++column) {
      for (int axis = 0; axis < structure.dimension; ++axis) {
        loads(degrees.number(axis, candidate.node), column) = frame(axis, direction);
      }
    }
  }
  return loads;
}

}  // namespace

PreciseMatrix precise_compliance(const Structure& structure) {
  const FreeDegrees degrees = free_degrees(structure);
  const Eigen::SimplicialLLT<SparseMatrix> factorised(stiffness(structure, degrees));
  if (factorised.info() != Eigen::Success) {
    throw std::logic_error("the stiffness of a sound structure has no factorisation");
  }
  const PreciseMatrix loads = unit_loads(structure, degrees);
  const PreciseMatrix compliance = loads.transpose() * factorised.solve(loads);
  return (compliance + compliance.transpose()) / 2;
}

}  // namespace kusabi::problems
