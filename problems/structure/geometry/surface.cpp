// Faces that belong to one element only, and the cone of normals at a node.
#include "problems/structure/geometry/surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/LU>

#include "problems/structure/geometry/element_faces.hpp"
#include "problems/structure/geometry/face_geometry.hpp"
#include "problems/structure/geometry/face_list.hpp"
#include "problems/structure/model/element_shape.hpp"

namespace kusabi::problems {
namespace {

/// Sums of normals below this part of the sum of their lengths have no significant direction.
constexpr double cancelled_normals = 1e-6;

/// Unit normals are dependent if the determinant of their Gram matrix is below this: less than a
/// millionth of a radian apart.
constexpr double dependent_normals = 1e-12;

/// True if an element has the opposite orientation: the normal of its first face then points
/// inwards.
bool inside_out(const Structure& structure, const Element& element) {
  const auto& face = element_faces(element.shape).front();
  Eigen::MatrixXd places(structure.dimension, static_cast<Eigen::Index>(face.size()));
  for (std::size_t i = 0; i < face.size(); ++i) {
    places.col(static_cast<Eigen::Index>(i)) =
        structure.coordinates.col(element.nodes[static_cast<std::size_t>(face[i])]);
  }
  Eigen::VectorXd middle = Eigen::VectorXd::Zero(structure.dimension);
  const int vertices = shape_traits(element.shape).vertices;
  for (int vertex = 0; vertex < vertices; ++vertex) {
    middle += structure.coordinates.col(element.nodes[static_cast<std::size_t>(vertex)]);
  }
  middle /= vertices;
  // The straight face through the vertices, since a curved one may extend beyond the centre.
  const auto straight = static_cast<Eigen::Index>(
      std::ranges::count_if(face, [&](int node) { return node < vertices; }));
  const Eigen::MatrixXd flat = places.leftCols(straight);
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(structure.dimension);
  for (int node = 0; node < static_cast<int>(straight); ++node) mean += face_normal(flat, node);
  return mean.dot(face_centre(flat) - middle) < 0;
}

}  // namespace

Surface::Surface(const Structure& structure) : structure_(&structure) {
  for (int element = 0; element < body_elements(structure); ++element) {
    inside_out_.push_back(inside_out(structure, body_element(structure, element)));
  }
  const auto keys = faces_by_vertices(structure);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto same = [&](std::size_t j) { return keys[j].vertices == keys[i].vertices; };
    if ((i > 0 && same(i - 1)) || (i + 1 < keys.size() && same(i + 1))) continue;
    const Element& own = body_element(structure, keys[i].element);
    SurfaceFace face{keys[i].element, {}, 0};
    for (const int node : element_faces(own.shape)[static_cast<std::size_t>(keys[i].face)]) {
      face.nodes.push_back(own.nodes[static_cast<std::size_t>(node)]);
      if (node < shape_traits(own.shape).vertices) ++face.vertices;
    }
    for (const int node : face.nodes) at_node_.emplace_back(node, static_cast<int>(faces_.size()));
    faces_.push_back(std::move(face));
  }
  std::ranges::sort(at_node_);
}

std::vector<int> Surface::faces_at(int node) const {
  std::vector<int> result;
  const auto first = std::ranges::lower_bound(at_node_, std::pair(node, 0));
  for (auto entry = first; entry != at_node_.end() && entry->first == node; ++entry) {
    result.push_back(entry->second);
  }
  return result;
}

Eigen::MatrixXd Surface::places(const SurfaceFace& face) const {
  Eigen::MatrixXd result(structure_->dimension, static_cast<Eigen::Index>(face.nodes.size()));
  for (std::size_t i = 0; i < face.nodes.size(); ++i) {
    result.col(static_cast<Eigen::Index>(i)) = structure_->coordinates.col(face.nodes[i]);
  }
  return result;
}

Eigen::VectorXd Surface::normal(int face, int node) const {
  const SurfaceFace& own = faces_[static_cast<std::size_t>(face)];
  const auto at = static_cast<int>(std::ranges::find(own.nodes, node) - own.nodes.begin());
  const Eigen::VectorXd normal = face_normal(places(own), at);
  return inside_out_[static_cast<std::size_t>(own.element)] ? Eigen::VectorXd(-normal) : normal;
}

std::optional<Eigen::VectorXd> Surface::mean_normal(
    int node, const std::function<bool(const SurfaceFace&)>& wanted) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(structure_->dimension);
  double sizes = 0;
  for (const int face : faces_at(node)) {
    const SurfaceFace& own = faces_[static_cast<std::size_t>(face)];
    if (!wanted(own)) continue;
    const double size = face_size(places(own));
    sum += size * normal(face, node);
    sizes += size;
  }
  // Opposite faces, as those of a crack, have no significant mean normal.
  if (!(sum.stableNorm() > cancelled_normals * sizes)) return std::nullopt;
  return sum.stableNormalized();
}

namespace {

/// The cosine of the angle between a unit `direction` and its projection onto the span of the
/// columns, if that is a combination with nonnegative weights; -1 if it is not, or if the columns
/// are dependent.
template <int count>
double cosine(const Eigen::Matrix<double, Eigen::Dynamic, count>& normals,
              const Eigen::VectorXd& direction) {
  const Eigen::Matrix<double, count, count> products = normals.transpose() * normals;
  if (!(std::abs(products.determinant()) > dependent_normals)) return -1;
  const Eigen::Matrix<double, count, 1> sides = normals.transpose() * direction;
  const Eigen::Matrix<double, count, 1> weights = products.inverse() * sides;
  if (!(weights.minCoeff() >= 0)) return -1;
  return std::sqrt(std::max(0.0, sides.dot(weights)));
}

}  // namespace

double angle_from_cone(const std::vector<Eigen::VectorXd>& normals,
                       const Eigen::VectorXd& direction) {
  double best = -1;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    best = std::max(best, normals[i].dot(direction));
    for (std::size_t j = 0; j < i; ++j) {
      Eigen::Matrix<double, Eigen::Dynamic, 2> two(direction.size(), 2);
      two << normals[i], normals[j];
      best = std::max(best, cosine<2>(two, direction));
      if (direction.size() == 2) continue;
      for (std::size_t k = 0; k < j; ++k) {
        Eigen::Matrix<double, Eigen::Dynamic, 3> three(direction.size(), 3);
        three << normals[i], normals[j], normals[k];
        best = std::max(best, cosine<3>(three, direction));
      }
    }
  }
  return std::acos(std::clamp(best, -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace kusabi::problems
