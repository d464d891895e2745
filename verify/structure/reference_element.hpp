// What all elements of one shape have in common: the slopes of the shape functions where the
// stiffness is integrated, enclosed. The shape functions are found from what they are: the
// polynomials of the shape's space that are 1 at one node and 0 at all others.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "verify/arithmetic/enclosure.hpp"

namespace kusabi::verify {

/// A point of the rule of integration.
struct ReferencePoint {
  Enclosure weight;
  std::vector<std::array<Enclosure, 3>> slopes;  ///< of each node's function along xi, eta, zeta
};

/// The points of the shape with so many nodes: 3, 6, 4, 8 in the plane, 4, 10, 8, 20 in space.
/// @throws std::invalid_argument if there is none
const std::vector<ReferencePoint>& reference_points(std::size_t dimension, std::size_t nodes);

}  // namespace kusabi::verify
