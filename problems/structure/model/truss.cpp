// Assembly of the stiffness of a truss from its members.
#include "problems/structure/model/truss.hpp"

#include <cstddef>

#include "problems/structure/model/constraints.hpp"
#include "problems/structure/model/elongation.hpp"
#include "problems/structure/model/several_normals.hpp"

namespace kusabi::problems {
namespace {

double length(const Structure& structure, const Member& member) {
  return extent<double>(structure, member).stableNorm();
}

}  // namespace

FreeDegrees free_degrees(const Structure& structure) {
  FreeDegrees degrees;
  degrees.number.setConstant(structure.dimension, structure.coordinates.cols(), -1);
  const auto made = dependent_displacements(structure);
  for (int node = 0; node < static_cast<int>(structure.coordinates.cols()); ++node) {
    for (int axis = 0; axis < structure.dimension; ++axis) {
      if (structure.fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(axis)]) continue;
      if (made.contains({node, axis})) continue;
      degrees.number(axis, node) = degrees.of_nodes();
      degrees.free.push_back({node, axis});
    }
  }
  degrees.several_normals = nodes_with_several_normals(structure);
  set_master_degrees(structure, degrees);
  for (const Superelement& each : structure.superelements) {
    auto& own = degrees.internal_unknowns.emplace_back();
    for (const SuperelementRow& row : each.rows)
      own.push_back(row.node < 0 ? degrees.of_nodes() + degrees.internal_count++ : -1);
  }
  return degrees;
}

Eigen::VectorXd member_stiffnesses(const Structure& structure) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(structure.members.size()));
  for (Eigen::Index index = 0; index < result.size(); ++index) {
    const Member& member = structure.members[static_cast<std::size_t>(index)];
    result(index) = member.axial_stiffness / length(structure, member);
  }
  return result;
}

Eigen::SparseMatrix<double> truss_stiffness(const Structure& structure, const FreeDegrees& degrees,
                                            const Eigen::VectorXd& member_stiffness) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index index = 0; index < member_stiffness.size(); ++index) {
    const Member& member = structure.members[static_cast<std::size_t>(index)];
    add_square(elongation_vector<double>(structure, degrees, member), member_stiffness(index),
               entries);
  }
  Eigen::SparseMatrix<double> stiffness(degrees.size(), degrees.size());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

Eigen::SparseMatrix<double> equilibrium_matrix(const Structure& structure,
                                               const FreeDegrees& degrees) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t index = 0; index < structure.members.size(); ++index) {
    for (const auto& entry :
         elongation_vector<double>(structure, degrees, structure.members[index])) {
      if (entry.value == 0) continue;
      entries.emplace_back(entry.number, static_cast<int>(index), entry.value);
    }
  }
  Eigen::SparseMatrix<double> matrix(degrees.size(),
                                     static_cast<Eigen::Index>(structure.members.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::VectorXd elongations(const Structure& structure, const FreeDegrees& degrees,
                            const Eigen::VectorXd& displacement) {
  Eigen::VectorXd result =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(structure.members.size()));
  for (Eigen::Index index = 0; index < result.size(); ++index) {
    const Member& member = structure.members[static_cast<std::size_t>(index)];
    for (const auto& entry : elongation_vector<double>(structure, degrees, member)) {
      result(index) += entry.value * displacement(entry.number);
    }
  }
  return result;
}

}  // namespace kusabi::problems
