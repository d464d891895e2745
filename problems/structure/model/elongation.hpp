// Elongation of a member as a linear function of displacements: the vectors b_e of the stiffness of
// a truss, sum_e k_e b_e b_e^T, in any precision.
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// One entry of b_e, or of another linear measure of strain: its derivative by a free displacement.
template <class Scalar>
struct Elongation {
  int number;  ///< of the free displacement
  Scalar value;
};

/// The entries of b_e. A number may occur more than once if displacements are dependent; the
/// entries are then added.
template <class Scalar>
using StrainVector = std::vector<Elongation<Scalar>>;

namespace detail {

template <class Scalar>
Scalar times(const Scalar& value, const numbers::Precise& weight) {
  if constexpr (std::is_same_v<Scalar, double>) {
    return value * numbers::rounded(weight);
  } else {
    return value * weight;
  }
}

}  // namespace detail

/// Adds the entry of a node's displacement along an axis to its master degrees of freedom: none if
/// it is fixed.
template <class Scalar>
void add_entry(const FreeDegrees& degrees, int axis, int node, const Scalar& value,
               StrainVector<Scalar>& vector) {
  if (const int number = degrees.number(axis, node); number >= 0) vector.push_back({number, value});
  if (degrees.master_degrees.empty()) return;
  const auto place = static_cast<std::size_t>(degrees.number.rows() * node + axis);
  for (const auto& [number, weight] : degrees.master_degrees[place]) {
    vector.push_back({number, detail::times(value, weight)});
  }
}

/// The free displacements in the displacement of a node along an axis, with their weights.
template <class Scalar>
StrainVector<Scalar> parts_of(const FreeDegrees& degrees, int axis, int node) {
  StrainVector<Scalar> parts;
  add_entry(degrees, axis, node, Scalar(1.0), parts);
  return parts;
}

/// The vector from the first to the second end, length. Coordinates are taken as exact.
template <class Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, 1> extent(const Structure& structure, const Member& member) {
  return structure.coordinates.col(member.second).template cast<Scalar>() -
         structure.coordinates.col(member.first).template cast<Scalar>();
}

/// The nonzero part of b_e: minus and plus the member's direction, at its free displacements.
template <class Scalar>
StrainVector<Scalar> elongation_vector(const Structure& structure, const FreeDegrees& degrees,
                                       const Member& member) {
  const auto along = extent<Scalar>(structure, member);
  const Eigen::Matrix<Scalar, Eigen::Dynamic, 1> direction = along / along.stableNorm();
  StrainVector<Scalar> entries;
  for (int axis = 0; axis < structure.dimension; ++axis) {
    add_entry(degrees, axis, member.first, Scalar(-direction(axis)), entries);
    add_entry(degrees, axis, member.second, Scalar(direction(axis)), entries);
  }
  return entries;
}

/// EA / L of a member, force/length.
template <class Scalar>
Scalar bar_stiffness(const Structure& structure, const Member& member) {
  return Scalar(member.axial_stiffness) / extent<Scalar>(structure, member).stableNorm();
}

/// Adds `weight` b b^T to the entries of a matrix.
template <class Scalar>
void add_square(const StrainVector<Scalar>& vector, Scalar weight,
                std::vector<Eigen::Triplet<Scalar>>& entries) {
  for (const auto& row : vector) {
    for (const auto& column : vector) {
      // The product of the two entries is computed first, so that (i, j) and (j, i) have the same
      // rounding.
      entries.emplace_back(row.number, column.number, weight * (row.value * column.value));
    }
  }
}

}  // namespace kusabi::problems
