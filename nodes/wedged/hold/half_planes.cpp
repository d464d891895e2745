// Every pair of lines, tested against all half-planes: the numbers are small.
#include "nodes/wedged/hold/half_planes.hpp"

#include <algorithm>
#include <cmath>

namespace kusabi::wedged {
namespace {

/// Relative rounding of intersections, and angle below which two directions are one.
constexpr double rounding = 1e-12;
constexpr double same_direction = 1e-9;

double angle(const Eigen::Vector2d& point) {
  return std::atan2(point.y(), point.x());
}

bool inside(std::span<const HalfPlane> planes, const Eigen::Vector2d& point) {
  return std::ranges::all_of(planes, [&](const HalfPlane& plane) {
    return plane.normal.dot(point) <= plane.most + rounding * (plane.most + point.norm());
  });
}

// Adds a point, unless it is there, up to a distance.
void add(std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& point, double distance) {
  const bool known = std::ranges::any_of(
      points, [&](const auto& other) { return (other - point).norm() <= distance; });
  if (!known) points.push_back(point);
}

}  // namespace

Polygon intersection(std::span<const HalfPlane> planes) {
  Polygon polygon;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto& [a, c] = planes[i];
    for (const Eigen::Vector2d& along :
         {Eigen::Vector2d(-a.y(), a.x()), Eigen::Vector2d(a.y(), -a.x())}) {
      const bool endless = std::ranges::all_of(planes, [&](const HalfPlane& plane) {
        return plane.normal.dot(along) <= same_direction;
      });
      if (endless) add(polygon.rays, along, same_direction);
    }
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [b, e] = planes[j];
      const double determinant = a.x() * b.y() - a.y() * b.x();
      if (std::abs(determinant) <= same_direction) continue;
      const Eigen::Vector2d point(c * b.y() - e * a.y(), a.x() * e - b.x() * c);
      const Eigen::Vector2d vertex = point / determinant;
      if (inside(planes, vertex)) add(polygon.vertices, vertex, same_direction * vertex.norm());
    }
  }
  std::ranges::sort(polygon.vertices, {}, angle);
  std::ranges::sort(polygon.rays, {}, angle);
  return polygon;
}

}  // namespace kusabi::wedged
