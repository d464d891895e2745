// The surface of the body that the elements make up: the faces that one element has alone, and the
// directions in which it faces at a node.
//
// A node of the surface may touch an obstacle along any direction between those of its faces: along
// their one normal where the surface is smooth, within the cone of their normals at an edge or a
// corner. Bars have no surface.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// A face of one element that no other has.
struct SurfaceFace {
  int element;             ///< of `body_elements`
  std::vector<int> nodes;  ///< of the structure, in the order of `element_faces`
  int corners;             ///< how many of them are corners
};

class Surface {
 public:
  /// @param structure with elements of its dimension; it must outlive the surface
  explicit Surface(const Structure& structure);

  const std::vector<SurfaceFace>& faces() const { return faces_; }
  /// The numbers of the faces that a node is of.
  std::vector<int> faces_at(int node) const;

  /// The normal of a face at one of its nodes, out of the body: unit, d.
  Eigen::VectorXd normal(int face, int node) const;

  /// The mean of the normals at a node, out of the body, of the faces that are `wanted`, weighted
  /// with their areas (lengths): unit, d. Nothing if the node is of no such face, or if they
  /// cancel.
  std::optional<Eigen::VectorXd> mean_normal(
      int node, const std::function<bool(const SurfaceFace&)>& wanted) const;

 private:
  Eigen::MatrixXd places(const SurfaceFace& face) const;

  const Structure* structure_;
  std::vector<SurfaceFace> faces_;
  std::vector<bool> inside_out_;              // of elements that go round the other way
  std::vector<std::pair<int, int>> at_node_;  // node, face: sorted
};

/// A normal that points from the obstacle along less than this out of its way, in degrees, is not
/// worth a word: measures are typed with three digits.
inline constexpr double visible_angle = 1;

/// The angle in degrees between `direction` and the nearest one that is a sum of `normals` with
/// weights of zero or more; 90 and more: it is in the half-space behind all of them.
double angle_from_cone(const std::vector<Eigen::VectorXd>& normals,
                       const Eigen::VectorXd& direction);

/// Whether the normal of each candidate points from the obstacle into the body.
/// @throws InputError at the first one that points out of it
void check_normals(const Structure& structure);

/// One line for each normal of the file that is off the surface by more than `visible_angle`.
std::vector<std::string> normal_warnings(const Structure& structure);

}  // namespace kusabi::problems
