// Andrew's monotone chain, and Sutherland and Hodgman's clipping at each side of the box.
#include "pictures/svg/convex_area.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace kusabi::pictures {
namespace {

using Points = std::vector<Eigen::Vector2d>;

double turn(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

// The part with side * (point[axis] - limit) <= 0.
Points clipped(const Points& area, int axis, double limit, double side) {
  Points result;
  for (std::size_t i = 0; i < area.size(); ++i) {
    const auto& from = area[i];
    const auto& to = area[(i + 1) % area.size()];
    const double before = side * (from[axis] - limit);
    const double after = side * (to[axis] - limit);
    if (before <= 0) result.push_back(from);
    if (before * after < 0) result.emplace_back(from + (to - from) * (before / (before - after)));
  }
  return result;
}

}  // namespace

Points convex_hull(Points points) {
  std::ranges::sort(points, [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  Points chain;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = chain.size();
    for (const auto& point : points) {
      while (chain.size() >= start + 2 && turn(chain[chain.size() - 2], chain.back(), point) <= 0)
        chain.pop_back();
      chain.push_back(point);
    }
    chain.pop_back();
    std::ranges::reverse(points);
  }
  return chain;
}

Points convex_area(const Points& points, const Points& directions, const Eigen::AlignedBox2d& box) {
  Eigen::AlignedBox2d around = box;
  for (const auto& point : points) around.extend(point);
  const double far = 4 * around.sizes().norm();
  Points all = points;
  for (const auto& point : points)
    for (const auto& along : directions) all.emplace_back(point + far * along.normalized());
  Points area = convex_hull(std::move(all));
  for (int axis = 0; axis < 2; ++axis) {
    area = clipped(area, axis, box.max()[axis], 1);
    area = clipped(area, axis, box.min()[axis], -1);
  }
  return area;
}

}  // namespace kusabi::pictures
