// Free displacements q of a structure, and the matrix H of all displacements u = H q.
//
// H is the identity except for supports, which fix displacements; multi-point constraints, u_a =
// sum_k w_k u_bk; candidates opposite to another body, u_a = q_a + sum_k w_k u_bk, where q_a is
// their displacement relative to it; and inclined supports, u_i = -sum_j (d_j / d_i) u_j. Weights
// are doubles or enclosed quotients. A node with several candidates keeps its own displacements,
// u_a = q_a (verify/structure/several_normals.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "verify/arithmetic/enclosure.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// A symmetric matrix by rows; entries that are not stored are zero.
using SparseEnclosure = std::vector<std::map<std::size_t, Enclosure>>;

/// The axis of the largest component; the first of equal ones.
std::size_t largest_component_axis(const Vector& direction);

/// Numbers of free displacements: by node and axis, then the internal unknowns of given
/// stiffnesses.
struct Freedom {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t count = 0;
  /// By node and axis; `none` if the displacement is fixed or dependent.
  std::vector<std::array<std::size_t, 3>> number;
  /// By (node, axis) of dependent displacements: the free displacements in it and their weights.
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::pair<std::size_t, Enclosure>>>
      masters;

  /// By given stiffness and row: the number of an internal unknown, or `none`.
  std::vector<std::vector<std::size_t>> internal;

  explicit Freedom(const Structure& structure);

  /// All free displacements in a displacement, its own first.
  [[nodiscard]] std::vector<std::size_t> parts(std::size_t node, std::size_t axis) const;

  /// All free displacements in a displacement, with their weights.
  [[nodiscard]] std::vector<std::pair<std::size_t, Enclosure>> weighted(std::size_t node,
                                                                        std::size_t axis) const;

  /// Adds an entry between two displacements, each given by node and axis, to a matrix over the
  /// free ones: H' value H.
  void add(std::pair<std::size_t, std::size_t> row, std::pair<std::size_t, std::size_t> column,
           const Enclosure& value, SparseEnclosure& matrix) const;
};

}  // namespace kusabi::verify
