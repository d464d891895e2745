// Nearest point of a surface as a weighted sum of the nodes of one face, for contact with, or
// constraints to, a body with other nodes.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// A face of an element: its vertices, then the midpoints of its sides, if there are any. Two or
/// three nodes are an edge in the plane (three or six a triangle, four or eight a quadrilateral in
/// space).
using FaceNodes = std::vector<int>;

/// The faces of elements whose nodes are all in `group`, and the members whose ends both are.
std::vector<FaceNodes> faces_within(const Structure& structure, const std::vector<int>& group);

/// Tolerance of the distance between a node and its opposite place, relative to the size of the
/// face, or for two nodes to the size of the structure; the key `gap` overrides it.
inline constexpr double place_tolerance = 1e-6;

struct SurfacePlace {
  std::vector<WeightedNode> shares;  ///< multiples of 2^-40 that sum to 1 exactly, none zero
  double distance = 0;               ///< from the point, length
  double size = 0;                   ///< of the face: its largest extent along an axis
};

/// The nearest point of all faces. Nothing if there are no faces.
/// @param places of all nodes, d x nodes (or more columns)  @param point d
std::optional<SurfacePlace> nearest_place(const Eigen::Ref<const Eigen::MatrixXd>& places,
                                          const std::vector<FaceNodes>& faces,
                                          const Eigen::VectorXd& point);

}  // namespace kusabi::problems
