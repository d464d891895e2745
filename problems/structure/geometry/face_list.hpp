// Faces of all elements, so that those with the same vertices are adjacent.
#pragma once

#include <array>
#include <compare>
#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// A face of an element with its vertices in ascending order: -1 where it has fewer than four.
struct FaceKey {
  std::array<int, 4> vertices;
  int element;  ///< of `body_elements`
  int face;     ///< in `element_faces`

  auto operator<=>(const FaceKey&) const = default;
};

/// All faces, sorted by vertices, then by element.
std::vector<FaceKey> faces_by_vertices(const Structure& structure);

/// The nodes of a face, in the order of `element_faces`.
std::vector<int> nodes_of(const Structure& structure, const FaceKey& face);

}  // namespace kusabi::problems
