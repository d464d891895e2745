// Surface of the bodies of elements: faces that belong to one element only, and their normals at a
// node.
//
// A node of the surface may touch an obstacle along any direction between the normals of its faces:
// their common normal where the surface is smooth, the cone of normals at an edge or vertex. Bars
// have no surface.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// A face that belongs to one element only.
struct SurfaceFace {
  int element;             ///< of `body_elements`
  std::vector<int> nodes;  ///< of the structure, in the order of `element_faces`
  int vertices;            ///< number of vertices among them
};

class Surface {
 public:
  /// @param structure with elements of its dimension; it must outlive the surface
  explicit Surface(const Structure& structure);

  const std::vector<SurfaceFace>& faces() const { return faces_; }
  /// The faces of a node.
  std::vector<int> faces_at(int node) const;

  /// The outward unit normal of a face at one of its nodes, d.
  Eigen::VectorXd normal(int face, int node) const;

  /// The mean of the outward normals at a node over the `wanted` faces, weighted with their areas
  /// (lengths): unit, d. Nothing if the node has no such face, or if the normals cancel.
  std::optional<Eigen::VectorXd> mean_normal(
      int node, const std::function<bool(const SurfaceFace&)>& wanted) const;

 private:
  Eigen::MatrixXd places(const SurfaceFace& face) const;

  const Structure* structure_;
  std::vector<SurfaceFace> faces_;
  std::vector<bool> inside_out_;              // of elements with the opposite orientation
  std::vector<std::pair<int, int>> at_node_;  // node, face: sorted
};

/// Tolerance in degrees for normals that differ from the surface, since dimensions are typed with
/// three digits; smaller angles are not reported.
inline constexpr double visible_angle = 1;

/// The angle in degrees between `direction` and the nearest combination of `normals` with
/// nonnegative weights; 90 or more if it is in the half-space opposite to all of them.
double angle_from_cone(const std::vector<Eigen::VectorXd>& normals,
                       const Eigen::VectorXd& direction);

/// Checks that the normal of each candidate points from the obstacle into the body.
/// @throws InputError at the first that points out of the body
void check_normals(const Structure& structure);

/// One line for each normal of the file that differs from the surface by more than `visible_angle`.
std::vector<std::string> normal_warnings(const Structure& structure);

}  // namespace kusabi::problems
