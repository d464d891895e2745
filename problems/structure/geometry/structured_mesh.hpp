// Structured mesh of a quadrilateral: columns and rows of four-node elements, from its four
// vertices.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace kusabi::problems {

/// Maximum number of columns and of rows of a mesh.
inline constexpr int max_divisions = 1000;

/// Nodes of a mesh coincide with older nodes if they are closer than this, relative to the size of
/// the mesh. Rounding errors of coordinates are a million times smaller, elements larger.
inline constexpr double same_place = 1e-9;

/// Node i,j is i columns from the first vertex towards the second and j rows towards the fourth.
/// Nodes and elements are numbered row by row.
struct StructuredMesh {
  Eigen::Matrix<double, 2, 4> vertices;  ///< in circular order: (0, 0), (1, 0), (1, 1), (0, 1)
  int columns = 1;
  int rows = 1;

  bool is_convex() const;

  /// Coordinates of node i,j: bilinear in i and j. Length.
  Eigen::Vector2d place(int i, int j) const;

  /// The first column of `places` (2 x n) that coincides with `place`; -1 if there is none.
  int node_at(const Eigen::Ref<const Eigen::MatrixXd>& places, const Eigen::Vector2d& place) const;

  /// "left" and "right" in the order of j, "bottom" and "top" in that of i.
  /// @param numbers of all nodes, row by row
  std::vector<std::pair<const char*, std::vector<int>>> edges(
      const std::vector<int>& numbers) const;

  /// The vertices of each element, in the circular order of the mesh.
  std::vector<std::array<int, 4>> elements(const std::vector<int>& numbers) const;

 private:
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * (static_cast<std::size_t>(columns) + 1) +
           static_cast<std::size_t>(i);
  }
};

/// The first of `nodes` that lies on `edge` between two of its nodes, where two meshes would not be
/// connected. -1 if there is none.
/// @param places of all nodes, 2 x n  @param edge, nodes numbers of nodes along one edge each
int node_between(const Eigen::Ref<const Eigen::MatrixXd>& places, const std::vector<int>& edge,
                 const std::vector<int>& nodes);

/// Node name: "body", 3, 0 gives "body.3,0".
std::string mesh_node(const std::string& mesh, int i, int j);

}  // namespace kusabi::problems
