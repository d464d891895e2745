// Convex sets in the plane: intersections of half-planes, and hulls of points and directions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace kusabi::wedged {

/// Points x with normal'x <= maximum.
struct HalfPlane {
  Eigen::Vector2d normal;  ///< unit
  double maximum;
};

/// The convex hull of the vertices, plus all multiples of the rays.
struct Polygon {
  std::vector<Eigen::Vector2d> vertices{};  ///< of intersection(): in the order of their angles
                                            ///< about the origin
  std::vector<Eigen::Vector2d> rays{};      ///< unit; none: bounded
};

/// Vertices and extreme directions; no vertices for a half-plane or a strip.
Polygon intersection(std::span<const HalfPlane> planes);

/// The part of two hulls with interior that is common to both; nothing if it has no interior.
std::optional<Polygon> common_part(const Polygon& one, const Polygon& other);

/// The hull without vertices that coincide with another one, up to `same`, or are on the line
/// between their neighbours, up to `flat`; both relative to the distance from a point inside.
Polygon with_corners_only(Polygon hull, const Eigen::Vector2d& inside, double same, double flat);

}  // namespace kusabi::wedged
