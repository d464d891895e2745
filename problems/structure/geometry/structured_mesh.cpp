// Nodes, edges and elements of a structured mesh.
#include "problems/structure/geometry/structured_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/LU>
#include <fmt/format.h>

namespace kusabi::problems {

bool StructuredMesh::is_convex() const {
  int turns = 0;
  for (int vertex = 0; vertex < 4; ++vertex) {
    Eigen::Matrix2d sides;
    sides.col(0) = vertices.col((vertex + 1) % 4) - vertices.col(vertex);
    sides.col(1) = vertices.col((vertex + 3) % 4) - vertices.col(vertex);
    const double area = sides.determinant();
    turns += (area > 0 ? 1 : 0) - (area < 0 ? 1 : 0);
  }
  return turns == 4 || turns == -4;
}

Eigen::Vector2d StructuredMesh::place(int i, int j) const {
  const double x = static_cast<double>(i) / columns;
  const double y = static_cast<double>(j) / rows;
  return vertices * Eigen::Vector4d((1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y);
}

int StructuredMesh::node_at(const Eigen::Ref<const Eigen::MatrixXd>& places,
                            const Eigen::Vector2d& place) const {
  const double size = (vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff()).maxCoeff();
  for (Eigen::Index node = 0; node < places.cols(); ++node) {
    if ((places.col(node) - place).cwiseAbs().maxCoeff() <= same_place * size) {
      return static_cast<int>(node);
    }
  }
  return -1;
}

std::vector<std::pair<const char*, std::vector<int>>> StructuredMesh::edges(
    const std::vector<int>& numbers) const {
  std::vector<int> left;
  std::vector<int> right;
  for (int j = 0; j <= rows; ++j) {
    left.push_back(numbers[at(0, j)]);
    right.push_back(numbers[at(columns, j)]);
  }
  std::vector<int> bottom;
  std::vector<int> top;
  for (int i = 0; i <= columns; ++i) {
    bottom.push_back(numbers[at(i, 0)]);
    top.push_back(numbers[at(i, rows)]);
  }
  return {{"left", left}, {"right", right}, {"bottom", bottom}, {"top", top}};
}

std::vector<std::array<int, 4>> StructuredMesh::elements(const std::vector<int>& numbers) const {
  std::vector<std::array<int, 4>> all;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      all.push_back({numbers[at(i, j)], numbers[at(i + 1, j)], numbers[at(i + 1, j + 1)],
                     numbers[at(i, j + 1)]});
    }
  }
  return all;
}

int node_between(const Eigen::Ref<const Eigen::MatrixXd>& places, const std::vector<int>& edge,
                 const std::vector<int>& nodes) {
  for (const int node : nodes) {
    if (std::ranges::find(edge, node) != edge.end()) continue;
    for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
      const Eigen::Vector2d along = places.col(edge[i + 1]) - places.col(edge[i]);
      const Eigen::Vector2d to = places.col(node) - places.col(edge[i]);
      const double length = along.norm();
      const double share = along.dot(to) / (length * length);
      const double off = std::abs(along.x() * to.y() - along.y() * to.x()) / length;
      if (share > 0 && share < 1 && off <= same_place * length) return node;
    }
  }
  return -1;
}

std::string mesh_node(const std::string& mesh, int i, int j) {
  return fmt::format("{}.{},{}", mesh, i, j);
}

}  // namespace kusabi::problems
