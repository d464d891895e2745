// Data common to all elements of one shape: enclosed gradients of the shape functions at the
// integration points. The shape functions are determined by their definition: the polynomials of
// the shape's space that are 1 at one node and 0 at all others.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "verify/arithmetic/enclosure.hpp"

namespace kusabi::verify {

/// An integration point.
struct ReferencePoint {
  Enclosure weight;
  /// Of each node's shape function along xi, eta, zeta.
  std::vector<std::array<Enclosure, 3>> slopes;
};

/// The integration points of the shape with this number of nodes: 3, 6, 4 or 8 in the plane, 4, 10,
/// 8, 20, 6, 15 or 5 in space.
/// @throws std::invalid_argument if there is no such shape
const std::vector<ReferencePoint>& reference_points(std::size_t dimension, std::size_t nodes);

}  // namespace kusabi::verify
