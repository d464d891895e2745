// Derivatives of the shape functions of faces, and tangents, normals and areas derived from them.
#include "problems/structure/geometry/face_geometry.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace kusabi::problems {
namespace {

/// A point of the reference face: s in [-1, 1] of an edge, (s, t) in the unit triangle or the
/// square of side 2.
struct Point {
  double s = 0;
  double t = 0;
  double weight = 0;
};

const double gauss2 = 1 / std::sqrt(3.0);
const double gauss3 = std::sqrt(0.6);

/// The vertices of the square, then the midpoints of its sides.
const std::vector<Point> square_points{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0},
                                       {0, -1, 0},  {1, 0, 0},  {0, 1, 0}, {-1, 0, 0}};
const std::vector<Point> triangle_points{{0, 0, 0},   {1, 0, 0},     {0, 1, 0},
                                         {0.5, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}};
const std::vector<Point> edge_points{{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}};

bool is_triangle(Eigen::Index nodes) {
  return nodes == 3 || nodes == 6;
}

/// d N / d s and d N / d t of each node, k x 2.
using Derivatives = Eigen::Matrix<double, Eigen::Dynamic, 2>;

Derivatives edge_derivatives(Eigen::Index nodes, const Point& at) {
  Derivatives slopes = Derivatives::Zero(nodes, 2);
  if (nodes == 2) {
    slopes.col(0) << -0.5, 0.5;
  } else {
    slopes.col(0) << at.s - 0.5, at.s + 0.5, -2 * at.s;
  }
  return slopes;
}

Derivatives triangle_derivatives(Eigen::Index nodes, const Point& at) {
  Derivatives slopes(nodes, 2);
  if (nodes == 3) {
    slopes << -1, -1, 1, 0, 0, 1;
    return slopes;
  }
  const double rest = 1 - at.s - at.t;
  slopes << 1 - 4 * rest, 1 - 4 * rest,  //
      4 * at.s - 1, 0,                   //
      0, 4 * at.t - 1,                   //
      4 * (rest - at.s), -4 * at.s,      //
      4 * at.t, 4 * at.s,                //
      -4 * at.t, 4 * (rest - at.t);
  return slopes;
}

Derivatives square_derivatives(Eigen::Index nodes, const Point& at) {
  Derivatives slopes(nodes, 2);
  for (Eigen::Index node = 0; node < nodes; ++node) {
    const Point& own = square_points[static_cast<std::size_t>(node)];
    const double s = at.s * own.s;
    const double t = at.t * own.t;
    if (nodes == 4) {
      slopes.row(node) << own.s * (1 + t) / 4, own.t * (1 + s) / 4;
    } else if (node < 4) {
      slopes.row(node) << own.s * (1 + t) * (2 * s + t) / 4, own.t * (1 + s) * (2 * t + s) / 4;
    } else if (own.s == 0) {
      slopes.row(node) << -at.s * (1 + t), own.t * (1 - at.s * at.s) / 2;
    } else {
      slopes.row(node) << own.s * (1 - at.t * at.t) / 2, -at.t * (1 + s);
    }
  }
  return slopes;
}

/// The normal times the area density of the face.
Eigen::VectorXd normal_at(const FaceCoordinates& places, const Point& at) {
  const Eigen::Index nodes = places.cols();
  if (places.rows() == 2) {
    const Eigen::Vector2d along = places * edge_derivatives(nodes, at).col(0);
    return Eigen::Vector2d(along.y(), -along.x());
  }
  const Eigen::Matrix<double, 3, 2> along =
      places *
      (is_triangle(nodes) ? triangle_derivatives(nodes, at) : square_derivatives(nodes, at));
  return along.col(0).cross(along.col(1));
}

std::vector<Point> gauss_points(const FaceCoordinates& places) {
  std::vector<Point> points;
  if (places.rows() == 2) {
    return {{-gauss3, 0, 5.0 / 9}, {0, 0, 8.0 / 9}, {gauss3, 0, 5.0 / 9}};
  }
  if (is_triangle(places.cols())) {
    return {{0.5, 0, 1.0 / 6}, {0.5, 0.5, 1.0 / 6}, {0, 0.5, 1.0 / 6}};
  }
  for (const double s : {-gauss2, gauss2}) {
    for (const double t : {-gauss2, gauss2}) points.push_back({s, t, 1});
  }
  return points;
}

}  // namespace

Eigen::VectorXd face_normal(const FaceCoordinates& places, int node) {
  const auto at = static_cast<std::size_t>(node);
  const Eigen::VectorXd normal =
      normal_at(places, places.rows() == 2           ? edge_points[at]
                        : is_triangle(places.cols()) ? triangle_points[at]
                                                     : square_points[at]);
  return normal.stableNormalized();
}

double face_size(const FaceCoordinates& places) {
  double size = 0;
  for (const Point& point : gauss_points(places)) {
    size += point.weight * normal_at(places, point).stableNorm();
  }
  return size;
}

Eigen::VectorXd face_centre(const FaceCoordinates& places) {
  const Eigen::Index nodes = places.cols();
  const Eigen::Index vertices = places.rows() == 2 ? 2 : is_triangle(nodes) ? 3 : 4;
  return places.leftCols(vertices).rowwise().mean();
}

}  // namespace kusabi::problems
