// Intersections of half-planes: a convex polygon, or an unbounded one with its extreme directions.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace kusabi::wedged {

/// Points x with normal'x <= most.
struct HalfPlane {
  Eigen::Vector2d normal;  ///< unit
  double most;
};

struct Polygon {
  std::vector<Eigen::Vector2d> vertices;  ///< in the order of their angles about the origin
  std::vector<Eigen::Vector2d> rays;      ///< unit; none: bounded
};

/// @pre the origin is inside of all of them
Polygon intersection(std::span<const HalfPlane> planes);

}  // namespace kusabi::wedged
