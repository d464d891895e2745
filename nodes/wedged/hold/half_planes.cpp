// Vertices by intersection of all pairs of lines, each tested against all half-planes; there are
// few.
#include "nodes/wedged/hold/half_planes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <tuple>

namespace kusabi::wedged {
namespace {

using Eigen::Vector2d;

/// Relative rounding of intersections, and angle below which two directions are one.
constexpr double rounding = 1e-12;
constexpr double same_direction = 1e-9;

/// Share by which vertices of a common part are moved inwards, to be within both in spite of
/// roundings.
constexpr double moved_inwards = 1e-8;

/// Size of a box in terms of the distances of lines, in which parts without vertices are found.
constexpr double large_box = 1e3;

double angle(const Vector2d& point) {
  return std::atan2(point.y(), point.x());
}

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool inside(std::span<const HalfPlane> planes, const Vector2d& point) {
  return std::ranges::all_of(planes, [&](const HalfPlane& plane) {
    return plane.normal.dot(point) <=
           plane.maximum + rounding * (std::abs(plane.maximum) + point.norm());
  });
}

// Adds a point, unless it is there, up to a distance.
void add(std::vector<Vector2d>& points, const Vector2d& point, double distance) {
  const bool known = std::ranges::any_of(
      points, [&](const auto& other) { return (other - point).norm() <= distance; });
  if (!known) points.push_back(point);
}

// Lines through two vertices, or through one along a ray, with the whole hull on one side.
std::vector<HalfPlane> edges_of(const Polygon& hull) {
  std::vector<HalfPlane> planes;
  const auto take = [&](const Vector2d& from, const Vector2d& along) {
    const double length = along.norm();
    if (length == 0) return;
    for (const double side : {1.0, -1.0}) {
      const Vector2d normal = Vector2d(-along.y(), along.x()) * (side / length);
      const bool outer = std::ranges::all_of(hull.vertices,
                                             [&](const auto& vertex) {
                                               return normal.dot(vertex - from) <=
                                                      same_direction * (vertex - from).norm();
                                             }) &&
                         std::ranges::all_of(hull.rays, [&](const auto& ray) {
                           return normal.dot(ray) <= same_direction;
                         });
      if (outer) planes.push_back({normal, normal.dot(from)});
    }
  };
  for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) take(hull.vertices[i], hull.vertices[j] - hull.vertices[i]);
    for (const auto& ray : hull.rays) take(hull.vertices[i], ray);
  }
  return planes;
}

// A point with a distance from all lines; nothing if there is none.
std::optional<Vector2d> point_inside(std::vector<HalfPlane> planes) {
  auto part = intersection(planes);
  double size = 1;
  for (const auto& plane : planes) size = std::max(size, std::abs(plane.maximum));
  if (part.vertices.empty()) {
    for (const Vector2d& normal :
         {Vector2d(1, 0), Vector2d(-1, 0), Vector2d(0, 1), Vector2d(0, -1)})
      planes.push_back({normal, large_box * size});
    part = intersection(planes);
    if (part.vertices.empty()) return {};
  }
  const Vector2d sum = std::reduce(part.vertices.begin(), part.vertices.end(), Vector2d(0, 0));
  Vector2d point = sum / static_cast<double>(part.vertices.size());
  double extent = part.rays.empty() ? 0 : size;
  for (const auto& vertex : part.vertices) extent = std::max(extent, (vertex - point).norm());
  for (const auto& ray : part.rays) point += extent * ray;
  const bool apart = std::ranges::all_of(planes, [&](const HalfPlane& plane) {
    return plane.maximum - plane.normal.dot(point) > same_direction * extent;
  });
  if (!apart) return {};
  return point;
}

}  // namespace

Polygon intersection(std::span<const HalfPlane> planes) {
  Polygon polygon;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto& [a, c] = planes[i];
    for (const Vector2d& along : {Vector2d(-a.y(), a.x()), Vector2d(a.y(), -a.x())}) {
      const bool unbounded = std::ranges::all_of(planes, [&](const HalfPlane& plane) {
        return plane.normal.dot(along) <= same_direction;
      });
      if (unbounded) add(polygon.rays, along, same_direction);
    }
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [b, e] = planes[j];
      const double determinant = cross(a, b);
      if (std::abs(determinant) <= same_direction) continue;
      const Vector2d point(c * b.y() - e * a.y(), a.x() * e - b.x() * c);
      const Vector2d vertex = point / determinant;
      if (inside(planes, vertex)) add(polygon.vertices, vertex, same_direction * vertex.norm());
    }
  }
  std::ranges::sort(polygon.vertices, {}, angle);
  std::ranges::sort(polygon.rays, {}, angle);
  return polygon;
}

std::optional<Polygon> common_part(const Polygon& one, const Polygon& other) {
  auto planes = edges_of(one);
  std::ranges::copy(edges_of(other), std::back_inserter(planes));
  const auto centre = point_inside(planes);
  if (!centre) return {};
  for (auto& plane : planes) plane.maximum -= plane.normal.dot(*centre);
  auto part = intersection(planes);
  // A half-plane or a strip: the points of its lines next to the centre.
  if (part.vertices.empty()) {
    for (const auto& plane : planes)
      if (inside(planes, plane.maximum * plane.normal))
        add(part.vertices, plane.maximum * plane.normal, same_direction * plane.maximum);
    if (part.vertices.size() == 1) part.rays.emplace_back(-part.vertices.front().normalized());
  }
  for (auto& vertex : part.vertices) vertex = *centre + (1 - moved_inwards) * vertex;
  return part;
}

Polygon with_corners_only(Polygon hull, const Vector2d& inside, double same, double flat) {
  struct Place {
    Vector2d at;  // from the point inside, or a direction
    bool ray;
  };
  std::vector<Place> around;
  for (const auto& ray : hull.rays) around.push_back({ray, true});
  for (const auto& vertex : hull.vertices) {
    const Vector2d at = vertex - inside;
    const bool known = std::ranges::any_of(around, [&](const Place& other) {
      return !other.ray && (other.at - at).norm() <= same * at.norm();
    });
    if (!known) around.push_back({at, false});
  }
  std::ranges::sort(around, {}, [](const Place& place) { return angle(place.at); });
  const auto is_flat = [&](std::size_t k) {
    const auto& [before, at, after] = std::tie(around[(k + around.size() - 1) % around.size()],
                                               around[k], around[(k + 1) % around.size()]);
    if (at.ray || (before.ray && after.ray)) return false;
    const Vector2d along = before.ray ? before.at : after.ray ? after.at : after.at - before.at;
    const Vector2d from = before.ray ? after.at : before.at;
    return std::abs(cross(along.normalized(), at.at - from)) <= flat * at.at.norm();
  };
  for (std::size_t k = 0; around.size() > 3 && k < around.size();) {
    if (is_flat(k)) {
      around.erase(around.begin() + static_cast<std::ptrdiff_t>(k));
      k = 0;
    } else {
      ++k;
    }
  }
  hull.vertices.clear();
  for (const auto& place : around)
    if (!place.ray) hull.vertices.emplace_back(inside + place.at);
  return hull;
}

}  // namespace kusabi::wedged
