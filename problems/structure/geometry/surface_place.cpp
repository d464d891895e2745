// Shape functions of faces; the nearest point by Gauss-Newton and Newton iterations.
#include "problems/structure/geometry/surface_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>

#include <Eigen/QR>

#include "problems/structure/geometry/element_faces.hpp"

namespace kusabi::problems {
namespace {

/// Parameters of a face: one on an edge, from -1 to 1; two on a surface, (x, y) of the unit
/// triangle or of the square from -1 to 1.
using Parameters = Eigen::VectorXd;

bool is_triangle(int dimension, std::size_t nodes) {
  return dimension == 3 && (nodes == 3 || nodes == 6);
}

Eigen::VectorXd edge_functions(std::size_t nodes, double s) {
  if (nodes == 2) return Eigen::Vector2d((1 - s) / 2, (1 + s) / 2);
  return Eigen::Vector3d(s * (s - 1) / 2, s * (s + 1) / 2, 1 - s * s);
}

Eigen::VectorXd triangle_functions(std::size_t nodes, double x, double y) {
  const double z = 1 - x - y;
  if (nodes == 3) return Eigen::Vector3d(z, x, y);
  Eigen::VectorXd values(6);
  values << z * (2 * z - 1), x * (2 * x - 1), y * (2 * y - 1), 4 * z * x, 4 * x * y, 4 * y * z;
  return values;
}

Eigen::VectorXd square_functions(std::size_t nodes, double x, double y) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(nodes));
  constexpr std::array<double, 4> across{-1, 1, 1, -1};
  constexpr std::array<double, 4> up{-1, -1, 1, 1};
  for (std::size_t vertex = 0; vertex < 4; ++vertex) {
    const double a = across[vertex] * x;
    const double b = up[vertex] * y;
    values(static_cast<Eigen::Index>(vertex)) =
        (1 + a) * (1 + b) / 4 * (nodes == 8 ? a + b - 1 : 1);
  }
  if (nodes == 8) {
    values.tail(4) << (1 - x * x) * (1 - y) / 2, (1 + x) * (1 - y * y) / 2,
        (1 - x * x) * (1 + y) / 2, (1 - x) * (1 - y * y) / 2;
  }
  return values;
}

Eigen::VectorXd functions(int dimension, std::size_t nodes, const Parameters& at) {
  if (at.size() == 1) return edge_functions(nodes, at(0));
  if (is_triangle(dimension, nodes)) return triangle_functions(nodes, at(0), at(1));
  return square_functions(nodes, at(0), at(1));
}

void bring_inside(bool triangle, Parameters& at) {
  if (!triangle) {
    at = at.cwiseMax(-1).cwiseMin(1);
    return;
  }
  at = at.cwiseMax(0);
  if (at.sum() > 1) at /= at.sum();
}

/// The shape functions at the nearest point of one face.
Eigen::VectorXd nearest_functions(const Eigen::MatrixXd& vertices, const Eigen::VectorXd& point) {
  constexpr int steps = 50;
  constexpr double settled = 1e-15;
  const auto dimension = static_cast<int>(vertices.rows());
  const auto nodes = static_cast<std::size_t>(vertices.cols());
  const bool edge = dimension == 2 || nodes == 2;
  const bool triangle = is_triangle(dimension, nodes);
  Parameters at = Parameters::Constant(edge ? 1 : 2, triangle ? 1.0 / 3 : 0.0);
  for (int step = 0; step < steps; ++step) {
    Eigen::MatrixXd slopes(dimension, at.size());
    for (Eigen::Index k = 0; k < at.size(); ++k) {
      // Exact, since the functions are quadratic in each parameter.
      const Parameters one = Parameters::Unit(at.size(), k);
      slopes.col(k) =
          vertices *
          (functions(dimension, nodes, at + one) - functions(dimension, nodes, at - one)) / 2;
    }
    const Eigen::VectorXd off = point - vertices * functions(dimension, nodes, at);
    const Parameters before = at;
    at += slopes.colPivHouseholderQr().solve(off);
    bring_inside(triangle, at);
    if ((at - before).cwiseAbs().maxCoeff() <= settled) break;
  }
  return functions(dimension, nodes, at);
}

/// The nearest multiples of 2^-40; the largest is adjusted such that the sum is one exactly. A
/// translation of all nodes then translates the place exactly.
std::vector<WeightedNode> shares_of(const FaceNodes& face, const Eigen::VectorXd& values) {
  constexpr double grid = 0x1p40;
  Eigen::VectorXd rounded = (values * grid).array().round() / grid;
  Eigen::Index largest = 0;
  values.cwiseAbs().maxCoeff(&largest);
  rounded(largest) = 0;
  rounded(largest) = 1 - rounded.sum();
  std::vector<WeightedNode> shares;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const double weight = rounded(static_cast<Eigen::Index>(i));
    if (weight != 0) shares.push_back({face[i], weight});
  }
  return shares;
}

std::vector<FaceNodes> faces_of(const Element& element) {
  std::vector<FaceNodes> faces;
  for (const auto& own : element_faces(element.shape)) {
    auto& face = faces.emplace_back();
    for (const int node : own) face.push_back(element.nodes[static_cast<std::size_t>(node)]);
  }
  return faces;
}

}  // namespace

std::vector<FaceNodes> faces_within(const Structure& structure, const std::vector<int>& group) {
  const std::set<int> members(group.begin(), group.end());
  const auto within = [&](const FaceNodes& face) {
    return std::ranges::all_of(face, [&](int node) { return members.contains(node); });
  };
  std::vector<FaceNodes> faces;
  for (int element = 0; element < body_elements(structure); ++element) {
    for (const FaceNodes& face : faces_of(body_element(structure, element))) {
      if (within(face)) faces.push_back(face);
    }
  }
  for (const Member& bar : structure.members) {
    if (within({bar.first, bar.second})) faces.push_back({bar.first, bar.second});
  }
  return faces;
}

std::optional<SurfacePlace> nearest_place(const Eigen::Ref<const Eigen::MatrixXd>& places,
                                          const std::vector<FaceNodes>& faces,
                                          const Eigen::VectorXd& point) {
  std::optional<SurfacePlace> best;
  for (const FaceNodes& face : faces) {
    Eigen::MatrixXd vertices(places.rows(), static_cast<Eigen::Index>(face.size()));
    for (std::size_t i = 0; i < face.size(); ++i)
      vertices.col(static_cast<Eigen::Index>(i)) = places.col(face[i]);
    const Eigen::VectorXd values = nearest_functions(vertices, point);
    const double distance = (point - vertices * values).norm();
    if (best && best->distance <= distance) continue;
    const double size = (vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff()).maxCoeff();
    best = SurfacePlace{shares_of(face, values), distance, size};
  }
  return best;
}

}  // namespace kusabi::problems
