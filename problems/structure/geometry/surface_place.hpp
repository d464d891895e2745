// The place of a surface that is nearest to a point, as a sum of shares of the nodes of one face:
// where a node touches, or is tied to, a body whose nodes are elsewhere.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// A face of an element: its corners, then the nodes in the middles of its sides, if there are any.
/// Two or three nodes are an edge in the plane (three or six a triangle, four or eight a
/// quadrilateral in space).
using FaceNodes = std::vector<int>;

/// The faces of elements all of whose nodes are of `group`, and the members both of whose ends are.
std::vector<FaceNodes> faces_within(const Structure& structure, const std::vector<int>& group);

struct SurfacePlace {
  std::vector<Share> shares;  ///< multiples of 2^-40 that sum to 1 exactly, none zero
  double distance = 0;        ///< from the point, length
  double size = 0;            ///< of the face: its longest extent along an axis
};

/// The nearest place of any of the faces. Nothing if there are no faces.
/// @param places of all nodes, d x nodes (or more columns)  @param point d
std::optional<SurfacePlace> nearest_place(const Eigen::Ref<const Eigen::MatrixXd>& places,
                                          const std::vector<FaceNodes>& faces,
                                          const Eigen::VectorXd& point);

}  // namespace kusabi::problems
