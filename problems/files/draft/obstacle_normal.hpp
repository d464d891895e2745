// Outward normal of the obstacle at a node: a direction, or the normal of the body's own surface,
// of a plane, a cylinder or a cone.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "problems/files/draft/obstacle_place.hpp"
#include "problems/files/draft/problem_draft.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/geometry/surface.hpp"

namespace kusabi::problems {

/// The value of `normal` of a group.
struct ObstacleNormal {
  /// The outward normal of the obstacle at a node: d, of any positive length.
  std::function<Eigen::VectorXd(const ListedNode&)> at;
  /// For a plane, a cylinder or a cone: its possible positions.
  std::optional<ParallelSurfaces> surfaces{};
  /// For the body's own surface: the largest angles, in degrees, between two faces whose mean is
  /// the normal at a node, and between the mean and one of them.
  std::function<std::pair<double, double>(const ListedNode&)> facets{};
};

/// The surface of the body, computed at the first request.
class LazySurface {
 public:
  explicit LazySurface(const Structure& structure) : structure_(&structure) {}
  const Surface& get() {
    if (!surface_) surface_.emplace(*structure_);
    return *surface_;
  }

 private:
  const Structure* structure_;
  std::optional<Surface> surface_;
};

/// The value of `normal` in a [[contact]] group.
/// @param group for its lists of nodes, whose faces `normal = "surface"` refers to
/// @param draft, surface they must outlive the result
ObstacleNormal obstacle_normal(const ProblemDraft& draft, const TomlTable& group,
                               LazySurface& surface);

}  // namespace kusabi::problems
