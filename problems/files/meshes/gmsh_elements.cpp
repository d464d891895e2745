// Tables of the Gmsh reference manual, sections "MSH file format" and "Node ordering".
#include "problems/files/meshes/gmsh_elements.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace kusabi::problems {
namespace {

constexpr std::array<std::pair<int, MeshShape>, 14> known{{{15, MeshShape::point},
                                                           {1, MeshShape::line2},
                                                           {8, MeshShape::line3},
                                                           {2, MeshShape::triangle3},
                                                           {9, MeshShape::triangle6},
                                                           {3, MeshShape::quadrilateral4},
                                                           {16, MeshShape::quadrilateral8},
                                                           {4, MeshShape::tetrahedron4},
                                                           {11, MeshShape::tetrahedron10},
                                                           {5, MeshShape::hexahedron8},
                                                           {17, MeshShape::hexahedron20},
                                                           {6, MeshShape::prism6},
                                                           {18, MeshShape::prism15},
                                                           {7, MeshShape::pyramid5}}};

constexpr std::array<std::pair<int, const char*>, 6> unknown{{{10, "a quadrilateral of 9 nodes"},
                                                              {12, "a hexahedron of 27 nodes"},
                                                              {13, "a prism of 18 nodes"},
                                                              {14, "a pyramid of 14 nodes"},
                                                              {19, "a pyramid of 13 nodes"},
                                                              {21, "a triangle of 10 nodes"}}};

/// Gmsh's index of the node at each place. Gmsh orders the edges of a tetrahedron as 01 12 20 30 23
/// 13, those of a hexahedron as 01 03 04 12 15 23 26 37 45 47 56 67, those of a prism as 01 02 03
/// 12 14 25 34 35 45.
constexpr std::array<int, 10> tetrahedron_order{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
constexpr std::array<int, 20> hexahedron_order{0,  1, 2,  3,  4,  5,  6,  7,  8,  11,
                                               13, 9, 16, 18, 19, 17, 10, 12, 14, 15};

constexpr std::array<int, 15> prism_order{0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11};

}  // namespace

std::optional<MeshShape> gmsh_shape(int type) {
  for (const auto& [number, shape] : known) {
    if (number == type) return shape;
  }
  return std::nullopt;
}

std::string gmsh_called(int type) {
  for (const auto& [number, called] : unknown) {
    if (number == type) return fmt::format("{} (type {})", called, type);
  }
  return fmt::format("of type {}", type);
}

std::string gmsh_remedy(int type) {
  constexpr int quadrilateral9 = 10;
  constexpr int hexahedron27 = 12;
  constexpr int prism18 = 13;
  if (type != quadrilateral9 && type != hexahedron27 && type != prism18) return "";
  return ", which Gmsh makes of second order with Mesh.SecondOrderIncomplete = 1";
}

std::vector<int> from_gmsh_order(MeshShape shape, const std::vector<int>& nodes) {
  std::span<const int> order;
  if (shape == MeshShape::tetrahedron10) order = tetrahedron_order;
  if (shape == MeshShape::hexahedron20) order = hexahedron_order;
  if (shape == MeshShape::prism15) order = prism_order;
  if (order.empty()) return nodes;
  std::vector<int> result;
  for (const int place : order) result.push_back(nodes[static_cast<std::size_t>(place)]);
  return result;
}

}  // namespace kusabi::problems
