// Convex areas within a box: hulls of points and directions, clipped.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace kusabi::pictures {

/// Corners of the convex hull, in circular order.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

/// The part in a box of the convex hull of points plus all multiples of directions, in circular
/// order; empty if there is none. @param points at least one
std::vector<Eigen::Vector2d> convex_area(const std::vector<Eigen::Vector2d>& points,
                                         const std::vector<Eigen::Vector2d>& directions,
                                         const Eigen::AlignedBox2d& box);

}  // namespace kusabi::pictures
