// The free displacements q of a structure, and what all displacements are made of: u = H q.
//
// H is the identity but for supports, which hold some; ties, u_a = sum_k w_k u_bk; candidates
// against another body, u_a = q_a + sum_k w_k u_bk, with q_a their displacement relative to it; and
// inclined supports, u_i = -sum_j (d_j / d_i) u_j. Every weight is a double, or a quotient
// enclosed. The node of several candidates keeps its own displacements, u_a = q_a
// (verify/structure/corner.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "verify/arithmetic/enclosure.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// A symmetric matrix, row by row; entries that are not there are zero.
using SparseEnclosure = std::vector<std::map<std::size_t, Enclosure>>;

/// The axis of the largest component, of equals the first.
std::size_t steepest_axis(const Vector& direction);

/// Node by node and axis by axis, then the unknowns that stiffnesses have of their own.
struct Freedom {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t count = 0;
  /// By node and axis; `none` if fixed or made of others alone.
  std::vector<std::array<std::size_t, 3>> number;
  /// By (node, axis), where there are any: other free displacements in this one, and their weights.
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::pair<std::size_t, Enclosure>>>
      others;

  /// By stiffness of another program and row: the number of an unknown of its own, or `none`.
  std::vector<std::vector<std::size_t>> own;

  explicit Freedom(const Structure& structure);

  /// All free displacements in one, its own first.
  [[nodiscard]] std::vector<std::size_t> parts(std::size_t node, std::size_t axis) const;

  /// All free displacements in one, and their weights.
  [[nodiscard]] std::vector<std::pair<std::size_t, Enclosure>> weighted(std::size_t node,
                                                                        std::size_t axis) const;

  /// Adds what stands between two displacements, each a node and an axis, to a matrix over the
  /// free ones: H' value H.
  void add(std::pair<std::size_t, std::size_t> row, std::pair<std::size_t, std::size_t> column,
           const Enclosure& value, SparseEnclosure& matrix) const;
};

}  // namespace kusabi::verify
