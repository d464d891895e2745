// Table of the kinds of elements in mesh files.
#include "problems/files/meshes/mesh_data.hpp"

#include <cstddef>

#include "problems/structure/geometry/element_faces.hpp"

namespace kusabi::problems {
namespace {

struct Kind {
  int dimension;
  int nodes;
  int vertices;
  std::string_view called;
};

constexpr std::array<Kind, 14> kinds{{{0, 1, 1, "a point"},
                                      {1, 2, 2, "a line of 2 nodes"},
                                      {1, 3, 2, "a line of 3 nodes"},
                                      {2, 3, 3, "a triangle of 3 nodes"},
                                      {2, 6, 3, "a triangle of 6 nodes"},
                                      {2, 4, 4, "a quadrilateral of 4 nodes"},
                                      {2, 8, 4, "a quadrilateral of 8 nodes"},
                                      {3, 4, 4, "a tetrahedron of 4 nodes"},
                                      {3, 10, 4, "a tetrahedron of 10 nodes"},
                                      {3, 8, 8, "a hexahedron of 8 nodes"},
                                      {3, 20, 8, "a hexahedron of 20 nodes"},
                                      {3, 6, 6, "a prism of 6 nodes"},
                                      {3, 15, 6, "a prism of 15 nodes"},
                                      {3, 5, 5, "a pyramid of 5 nodes"}}};

const Kind& kind_of(MeshShape shape) {
  return kinds[static_cast<std::size_t>(shape)];
}

}  // namespace

int mesh_dimension(MeshShape shape) {
  return kind_of(shape).dimension;
}

int mesh_nodes(MeshShape shape) {
  return kind_of(shape).nodes;
}

int mesh_corners(MeshShape shape) {
  return kind_of(shape).vertices;
}

std::string_view mesh_called(MeshShape shape) {
  return kind_of(shape).called;
}

ElementShape element_shape(MeshShape shape) {
  constexpr int first = static_cast<int>(MeshShape::triangle3);
  return static_cast<ElementShape>(static_cast<int>(shape) - first);
}

}  // namespace kusabi::problems
