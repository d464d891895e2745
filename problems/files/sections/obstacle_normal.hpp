// The outward normal of the obstacle at a node: a direction, that of the body's own surface, or
// that of a plane, a cylinder or a cone.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "problems/files/sections/obstacle_place.hpp"
#include "problems/files/sections/problem_draft.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/geometry/surface.hpp"

namespace kusabi::problems {

/// What `normal` of a group says.
struct ObstacleNormal {
  /// From a node to the outward normal of the obstacle there: d, of any length, not zero.
  std::function<Eigen::VectorXd(const ListedNode&)> at;
  /// Of a plane, a cylinder or a cone: where it may be.
  std::optional<ParallelSurfaces> surfaces{};
  /// Of the body's own surface: the largest angle, in degrees, between two faces whose mean the
  /// normal at a node is, and from the mean to one of them.
  std::function<std::pair<double, double>(const ListedNode&)> facets{};
};

/// The surface of the body, found when it is first asked for.
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
/// @param group for its lists of nodes, whose faces `normal = "surface"` means
/// @param draft, surface they must outlive the result
ObstacleNormal obstacle_normal(const ProblemDraft& draft, const TomlTable& group,
                               LazySurface& surface);

}  // namespace kusabi::problems
