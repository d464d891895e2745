// Where meshes meet: nodes at one place are one, and where faces lie on each other without that,
// the meshes would gape.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Places sorted for finding those near another.
class PlaceIndex {
 public:
  /// @param places d x n; they must outlive the index  @param nodes which of them
  PlaceIndex(const Eigen::Ref<const Eigen::MatrixXd>& places, const std::vector<int>& nodes);

  /// The least number of a node no farther than `tolerance` along each axis; -1 if there is none.
  int node_at(const Eigen::VectorXd& place, double tolerance) const;

  /// All nodes in a box.
  std::vector<int> nodes_in(const Eigen::VectorXd& least, const Eigen::VectorXd& most) const;

 private:
  Eigen::MatrixXd places_;
  std::vector<std::pair<double, int>> by_x_;
};

/// A node that lies on a face of another body, or of another element, but is none of its nodes.
struct Gape {
  int node;
  int element;
};

/// The first gape between elements from `first_new` on and those before it which are `joined`, or
/// within all of the former: faces that share corners and not the nodes between them, or a
/// quadrilateral on triangles. Faces count as flat.
/// @param joined one an element
std::optional<Gape> find_gape(const Structure& structure, int first_new,
                              const std::vector<bool>& joined);

}  // namespace kusabi::problems
