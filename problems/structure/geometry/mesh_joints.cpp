// Coincident nodes by a sorted list; nodes on faces by triangulation of the faces.
#include "problems/structure/geometry/mesh_joints.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>

#include <Eigen/Geometry>

#include "problems/structure/geometry/face_list.hpp"
#include "problems/structure/geometry/structured_mesh.hpp"
#include "problems/structure/geometry/surface.hpp"

namespace kusabi::problems {
namespace {

/// True if `place` lies on the straight edge between its ends, excluding them.
bool on_edge(const Eigen::VectorXd& from, const Eigen::VectorXd& to, const Eigen::VectorXd& place) {
  const Eigen::VectorXd along = to - from;
  const double length = along.norm();
  const double share = along.dot(place - from) / (length * length);
  const double off = (place - from - share * along).norm();
  return share > same_place && share < 1 - same_place && off <= same_place * length;
}

/// True if `place` lies in a triangle in space, excluding its vertices.
bool on_triangle(const std::array<Eigen::Vector3d, 3>& vertices, const Eigen::Vector3d& place) {
  const Eigen::Vector3d normal = (vertices[1] - vertices[0]).cross(vertices[2] - vertices[0]);
  const double area = normal.norm();
  const double size = std::sqrt(area);
  if (!(area > 0) || std::abs(normal.dot(place - vertices[0])) > same_place * area * size) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d& from = vertices[i];
    const Eigen::Vector3d& to = vertices[(i + 1) % 3];
    if ((place - from).norm() <= same_place * size) return false;
    if (normal.dot((to - from).cross(place - from)) < -same_place * area * area) return false;
  }
  return true;
}

bool lies_on(const Structure& structure, const SurfaceFace& face, int node) {
  if (std::ranges::find(face.nodes, node) != face.nodes.end()) return false;
  const auto place = [&](int index) -> Eigen::VectorXd {
    return structure.coordinates.col(face.nodes[static_cast<std::size_t>(index)]);
  };
  const Eigen::VectorXd own = structure.coordinates.col(node);
  if (structure.dimension == 2) return on_edge(place(0), place(1), own);
  if (on_triangle({place(0), place(1), place(2)}, own)) return true;
  return face.vertices == 4 && on_triangle({place(0), place(2), place(3)}, own);
}

/// The first of `nodes` that lies on a surface face of the `wanted` elements.
std::optional<MeshGap> node_on_face(const Structure& structure, const Surface& surface,
                                    const NodeIndex& nodes, const std::vector<bool>& wanted) {
  for (const SurfaceFace& face : surface.faces()) {
    if (!wanted[static_cast<std::size_t>(face.element)]) continue;
    Eigen::VectorXd minimum = structure.coordinates.col(face.nodes.front());
    Eigen::VectorXd maximum = minimum;
    for (int vertex = 1; vertex < face.vertices; ++vertex) {
      const auto place = structure.coordinates.col(face.nodes[static_cast<std::size_t>(vertex)]);
      minimum = minimum.cwiseMin(place);
      maximum = maximum.cwiseMax(place);
    }
    const double margin = same_place * (maximum - minimum).maxCoeff();
    minimum.array() -= margin;
    maximum.array() += margin;
    for (const int node : nodes.nodes_in(minimum, maximum)) {
      if (lies_on(structure, face, node)) return MeshGap{node, face.element};
    }
  }
  return std::nullopt;
}

NodeIndex surface_nodes(const Structure& structure, const Surface& surface,
                        const std::vector<bool>& wanted) {
  std::set<int> nodes;
  for (const SurfaceFace& face : surface.faces()) {
    if (wanted[static_cast<std::size_t>(face.element)]) {
      nodes.insert(face.nodes.begin(), face.nodes.end());
    }
  }
  return {structure.coordinates, {nodes.begin(), nodes.end()}};
}

/// Two faces with the same vertices, one of which has a midpoint node that the other does not have.
std::optional<MeshGap> gap_in_the_middle(const Structure& structure, int first) {
  const auto middles = [&](const FaceKey& face) {
    auto nodes = nodes_of(structure, face);
    const auto vertices = std::ranges::count_if(face.vertices, [](int node) { return node >= 0; });
    nodes.erase(nodes.begin(), nodes.begin() + vertices);
    std::ranges::sort(nodes);
    return nodes;
  };
  const auto faces = faces_by_vertices(structure);
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i].vertices != faces[i - 1].vertices || faces[i].element < first) continue;
    const auto one = middles(faces[i - 1]);
    const auto other = middles(faces[i]);
    if (one == other) continue;
    return MeshGap{(one.size() > other.size() ? one : other).front(), faces[i].element};
  }
  return std::nullopt;
}

/// A triangle whose vertices are vertices of a quadrilateral: the surfaces differ between them.
std::optional<MeshGap> triangle_on_quadrilateral(const Surface& surface, int first) {
  for (const SurfaceFace& face : surface.faces()) {
    if (face.vertices != 3) continue;
    for (const int other : surface.faces_at(face.nodes[0])) {
      const SurfaceFace& square = surface.faces()[static_cast<std::size_t>(other)];
      if (square.vertices != 4 || std::max(square.element, face.element) < first) continue;
      const auto is_of_square = [&](int node) {
        return std::find(square.nodes.begin(), square.nodes.begin() + 4, node) !=
               square.nodes.begin() + 4;
      };
      if (is_of_square(face.nodes[1]) && is_of_square(face.nodes[2])) {
        return MeshGap{face.nodes[0], std::max(square.element, face.element)};
      }
    }
  }
  return std::nullopt;
}

}  // namespace

NodeIndex::NodeIndex(const Eigen::Ref<const Eigen::MatrixXd>& places, const std::vector<int>& nodes)
    : places_(places) {
  for (const int node : nodes) by_x_.emplace_back(places_(0, node), node);
  std::ranges::sort(by_x_);
}

std::vector<int> NodeIndex::nodes_in(const Eigen::VectorXd& minimum,
                                     const Eigen::VectorXd& maximum) const {
  std::vector<int> result;
  auto entry = std::ranges::lower_bound(by_x_, minimum(0), {}, &std::pair<double, int>::first);
  for (; entry != by_x_.end() && entry->first <= maximum(0); ++entry) {
    const auto place = places_.col(entry->second).array();
    if ((place >= minimum.array()).all() && (place <= maximum.array()).all()) {
      result.push_back(entry->second);
    }
  }
  return result;
}

int NodeIndex::node_at(const Eigen::VectorXd& place, double tolerance) const {
  const auto near = nodes_in(place.array() - tolerance, place.array() + tolerance);
  return near.empty() ? -1 : *std::ranges::min_element(near);
}

std::optional<MeshGap> find_mesh_gap(const Structure& structure, int first_new,
                                     const std::vector<bool>& joined) {
  if (const auto gap = gap_in_the_middle(structure, first_new)) return gap;
  const Surface surface(structure);
  if (const auto gap = triangle_on_quadrilateral(surface, first_new)) return gap;
  std::vector<bool> older = joined;
  std::vector<bool> newer = joined;
  for (std::size_t element = 0; element < joined.size(); ++element) {
    const bool is_new = static_cast<int>(element) >= first_new;
    (is_new ? older : newer)[element] = false;
  }
  const auto old_nodes = surface_nodes(structure, surface, older);
  if (const auto gap = node_on_face(structure, surface, old_nodes, newer)) return gap;
  const auto new_nodes = surface_nodes(structure, surface, newer);
  return node_on_face(structure, surface, new_nodes, older);
}

}  // namespace kusabi::problems
