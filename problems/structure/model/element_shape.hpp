// Shapes of elements: their nodes in natural coordinates, in the order of Abaqus and CalculiX
// (docs/problem-files.md).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// A point in natural coordinates xi, eta, zeta; zero beyond the dimension.
template <class Scalar>
using NaturalPoint = std::array<Scalar, 3>;

/// Domain of the natural coordinates.
enum class ShapeFamily {
  simplex,  ///< xi, eta, zeta >= 0 with a sum up to 1
  product,  ///< from -1 to 1 each
  prism,    ///< xi, eta >= 0 with a sum up to 1; zeta from -1 to 1
  pyramid,  ///< xi, eta from -1 to 1; zeta from -1 at the base to 0 at the apex
};

/// Data common to all elements of one shape.
struct ShapeTraits {
  std::string_view name;  ///< "ten-node tetrahedron"
  int dimension;
  ShapeFamily family;
  bool quadratic;  ///< a node in the middle of each edge
  int vertices;
  /// Vertices first, then the midpoints of edges.
  std::span<const NaturalPoint<double>> nodes;
};

const ShapeTraits& shape_traits(ElementShape shape);

/// The shape with this number of nodes: 3, 6, 4 or 8 in the plane, 4, 10, 8, 20, 6, 15 or 5 in
/// space.
std::optional<ElementShape> shape_of(int dimension, std::size_t nodes);

}  // namespace kusabi::problems
