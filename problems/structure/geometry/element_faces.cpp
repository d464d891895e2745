// Tables of vertices of faces and of sides with midpoint nodes, for each family of shapes.
#include "problems/structure/geometry/element_faces.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace kusabi::problems {
namespace {

using Faces = std::vector<std::vector<int>>;
using Sides = std::vector<std::pair<int, int>>;

/// A family of shapes: its vertices, and the order of its sides with midpoint nodes.
struct Family {
  int vertices;
  Faces faces;
  Sides sides;
};

const Family triangle{3, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1}, {1, 2}, {2, 0}}};
const Family quadrilateral{4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
const Family tetrahedron{4,
                         {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                         {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
const Family hexahedron{
    8,
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
    {{0, 1},
     {1, 2},
     {2, 3},
     {3, 0},
     {4, 5},
     {5, 6},
     {6, 7},
     {7, 4},
     {0, 4},
     {1, 5},
     {2, 6},
     {3, 7}}};

const Family prism{6,
                   {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
                   {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};

const Family pyramid{5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, {}};

const Family& family(ElementShape shape) {
  switch (shape) {
    case ElementShape::triangle3:
    case ElementShape::triangle6:
      return triangle;
    case ElementShape::quadrilateral4:
    case ElementShape::quadrilateral8:
      return quadrilateral;
    case ElementShape::tetrahedron4:
    case ElementShape::tetrahedron10:
      return tetrahedron;
    case ElementShape::prism6:
    case ElementShape::prism15:
      return prism;
    case ElementShape::pyramid5:
      return pyramid;
    case ElementShape::hexahedron8:
    case ElementShape::hexahedron20:
      break;
  }
  return hexahedron;
}

int middle(const Family& of, int first, int second) {
  const auto found = std::ranges::find_if(of.sides, [&](const auto& side) {
    return std::minmax(side.first, side.second) == std::minmax(first, second);
  });
  return of.vertices + static_cast<int>(found - of.sides.begin());
}

Faces with_middles(const Family& of) {
  Faces faces = of.faces;
  for (auto& face : faces) {
    const std::size_t vertices = face.size();
    const std::size_t sides =
        vertices == 2 ? 1 : vertices;  // an edge has one, a face as many as vertices
    for (std::size_t side = 0; side < sides; ++side) {
      face.push_back(middle(of, face[side], face[(side + 1) % vertices]));
    }
  }
  return faces;
}

}  // namespace

const std::vector<std::vector<int>>& element_faces(ElementShape shape) {
  static const std::array<Faces, 5> second_order{
      with_middles(triangle), with_middles(quadrilateral), with_middles(tetrahedron),
      with_middles(hexahedron), with_middles(prism)};
  switch (shape) {
    case ElementShape::triangle6:
      return second_order[0];
    case ElementShape::quadrilateral8:
      return second_order[1];
    case ElementShape::tetrahedron10:
      return second_order[2];
    case ElementShape::hexahedron20:
      return second_order[3];
    case ElementShape::prism15:
      return second_order[4];
    default:
      return family(shape).faces;
  }
}

}  // namespace kusabi::problems
