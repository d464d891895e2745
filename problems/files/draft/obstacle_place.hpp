// Check that candidates lie on the plane, cylinder or cone that defines their normals.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/files/draft/problem_draft.hpp"
#include "problems/structure/geometry/surface.hpp"

namespace kusabi::problems {

/// A family of parallel surfaces with the same normals: all planes with a normal, all cylinders
/// about an axis, all cones with an axis and a half angle.
struct ParallelSurfaces {
  std::string called;                 ///< such as "plane with this normal"
  std::function<double(int)> offset;  ///< of the surface through a node
  /// The outward normal of the obstacle at a node: d, of any length.
  std::function<Eigen::VectorXd(const ListedNode&)> normal;
};

/// Message with the number of nodes on none of the surfaces that contain a face of the body, and
/// their distance. Nothing if all are on one.
std::optional<std::string> place_fault(const ProblemDraft& draft, const Surface& body,
                                       const ParallelSurfaces& surfaces,
                                       const std::vector<ListedNode>& nodes);

}  // namespace kusabi::problems
