// Whether candidates are where the plane, the cylinder or the cone is whose normals they take.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/files/sections/problem_draft.hpp"
#include "problems/structure/geometry/surface.hpp"

namespace kusabi::problems {

/// A family of parallel surfaces that have the normals of the file: all planes of a normal, all
/// cylinders about an axis, all cones of an axis and a half angle.
struct ParallelSurfaces {
  std::string called;                 ///< "plane with this normal"
  std::function<double(int)> offset;  ///< of the one that goes through a node
  /// Out of the obstacle at a node: d, of any length.
  std::function<Eigen::VectorXd(const ListedNode&)> normal;
};

/// Says how many of the nodes are on none of these surfaces that a face of the body lies on, and
/// how far off. Nothing if all are.
std::optional<std::string> place_fault(const ProblemDraft& draft, const Surface& body,
                                       const ParallelSurfaces& surfaces,
                                       const std::vector<ListedNode>& nodes);

}  // namespace kusabi::problems
