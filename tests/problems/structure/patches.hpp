// Bodies divided into elements of each shape, for tests: the unit square or cube, in general with
// its interior nodes moved at random.
#pragma once

#include <algorithm>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems::test {

inline constexpr ElementShape all_shapes[] = {
    ElementShape::triangle3,      ElementShape::triangle6,    ElementShape::quadrilateral4,
    ElementShape::quadrilateral8, ElementShape::tetrahedron4, ElementShape::tetrahedron10,
    ElementShape::hexahedron8,    ElementShape::hexahedron20, ElementShape::prism6,
    ElementShape::prism15,        ElementShape::pyramid5};

std::string name_of(ElementShape shape);
/// Those of all_shapes for which a condition is true.
template <class Condition>
std::vector<ElementShape> shapes_if(Condition condition) {
  std::vector<ElementShape> shapes;
  std::ranges::copy_if(all_shapes, std::back_inserter(shapes), condition);
  return shapes;
}

int dimension_of(ElementShape shape);
bool is_quadratic(ElementShape shape);
int corners_of(ElementShape shape);

/// The edges with a midpoint node, as pairs of vertices, in the order of these nodes.
const std::vector<std::array<int, 2>>& edges_of(ElementShape shape);

/// Three cells along each axis. E = 200, nu = 0.3, thickness 0.5, plane stress.
/// @param moved largest random displacement of interior vertices as a share of a cell; midpoints of
///        edges follow, with a further third of that, except for tetrahedra and prisms, whose rule
///        is not exact for curves
Structure patch(ElementShape shape, double moved, std::mt19937& bits);

/// The middle element of the patch by itself.
Structure one_element(ElementShape shape, double moved, std::mt19937& bits);

/// True if a node is on the surface of the unit square or cube.
bool on_surface(const Structure& structure, int node);

}  // namespace kusabi::problems::test
