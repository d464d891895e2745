// Faces sorted by their vertices.
#include "problems/structure/geometry/face_list.hpp"

#include <algorithm>
#include <cstddef>

#include "problems/structure/geometry/element_faces.hpp"
#include "problems/structure/model/element_shape.hpp"

namespace kusabi::problems {

std::vector<FaceKey> faces_by_vertices(const Structure& structure) {
  std::vector<FaceKey> keys;
  for (int element = 0; element < body_elements(structure); ++element) {
    const Element& own = body_element(structure, element);
    const auto& faces = element_faces(own.shape);
    for (int face = 0; face < static_cast<int>(faces.size()); ++face) {
      FaceKey key{{-1, -1, -1, -1}, element, face};
      std::size_t vertex = 0;
      for (const int node : faces[static_cast<std::size_t>(face)]) {
        if (node >= shape_traits(own.shape).vertices) break;
        key.vertices[vertex++] = own.nodes[static_cast<std::size_t>(node)];
      }
      std::ranges::sort(key.vertices);
      keys.push_back(key);
    }
  }
  std::ranges::sort(keys);
  return keys;
}

std::vector<int> nodes_of(const Structure& structure, const FaceKey& face) {
  const Element& element = body_element(structure, face.element);
  std::vector<int> nodes;
  for (const int node : element_faces(element.shape)[static_cast<std::size_t>(face.face)]) {
    nodes.push_back(element.nodes[static_cast<std::size_t>(node)]);
  }
  return nodes;
}

}  // namespace kusabi::problems
