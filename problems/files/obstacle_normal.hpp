// The outward normal of the obstacle at a node: a direction, that of the body's own surface, or
// that of a plane, a cylinder or a cone.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "problems/files/problem_draft.hpp"
#include "problems/files/toml_reader.hpp"
#include "problems/structure/surface.hpp"

namespace kusabi::problems {

/// From a node to the outward normal of the obstacle there: d, of any length, not zero.
using ObstacleNormal = std::function<Eigen::VectorXd(const ListedNode&)>;

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
