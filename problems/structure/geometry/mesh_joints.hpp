// Joints between meshes: coincident nodes are merged, and faces that touch without common nodes are
// reported as gaps.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Sorted coordinates for the search of nearby nodes.
class NodeIndex {
 public:
  /// @param places d x n; they must outlive the index  @param nodes the columns in the index
  NodeIndex(const Eigen::Ref<const Eigen::MatrixXd>& places, const std::vector<int>& nodes);

  /// The least number of a node within `tolerance` along each axis; -1 if there is none.
  int node_at(const Eigen::VectorXd& place, double tolerance) const;

  /// All nodes in a box.
  std::vector<int> nodes_in(const Eigen::VectorXd& minimum, const Eigen::VectorXd& maximum) const;

 private:
  Eigen::MatrixXd places_;
  std::vector<std::pair<double, int>> by_x_;
};

/// A node that lies on a face of another body, or of another element, without belonging to it.
struct MeshGap {
  int node;
  int element;
};

/// The first gap between elements from `first_new` on and those before it which are `joined`, or
/// among the former: faces with the same vertices but different midpoints, or a quadrilateral on
/// triangles. Faces count as flat.
/// @param joined one for each element
std::optional<MeshGap> find_mesh_gap(const Structure& structure, int first_new,
                                     const std::vector<bool>& joined);

}  // namespace kusabi::problems
