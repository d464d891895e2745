// A quadrilateral cut into columns and rows of four-node elements, from its four corners.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace kusabi::problems {

/// Most columns, and most rows, of a mesh.
inline constexpr int most_divisions = 1000;

/// A node of a mesh lies on an older node if they are closer than this, relative to the size of the
/// mesh: roundings of the position are a million times smaller, elements larger.
inline constexpr double same_place = 1e-9;

/// Node i,j is i columns from the first corner towards the second, and j rows towards the fourth;
/// node numbers and elements come row by row.
struct StructuredMesh {
  Eigen::Matrix<double, 2, 4> corners;  ///< going round: (0, 0), (1, 0), (1, 1), (0, 1)
  int columns = 1;
  int rows = 1;

  bool is_convex() const;

  /// Where node i,j is: bilinear in i and j. Length.
  Eigen::Vector2d place(int i, int j) const;

  /// The column of `places` (2 x n) that is the same place as `place`, the first one; -1 if none
  /// is.
  int node_at(const Eigen::Ref<const Eigen::MatrixXd>& places, const Eigen::Vector2d& place) const;

  /// "left" and "right" from j = 0 on, "bottom" and "top" from i = 0 on.
  /// @param numbers of all nodes, row by row
  std::vector<std::pair<const char*, std::vector<int>>> edges(
      const std::vector<int>& numbers) const;

  /// The corners of each element, going round as those of the mesh do.
  std::vector<std::array<int, 4>> elements(const std::vector<int>& numbers) const;

 private:
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * (static_cast<std::size_t>(columns) + 1) +
           static_cast<std::size_t>(i);
  }
};

/// The first of `nodes` that lies on `edge` between two of its nodes: two meshes that touch there
/// would gape. -1 if there is none.
/// @param places of all nodes, 2 x n  @param edge, nodes numbers of nodes, along an edge each
int node_between(const Eigen::Ref<const Eigen::MatrixXd>& places, const std::vector<int>& edge,
                 const std::vector<int>& nodes);

/// "body", 3, 0: "body.3,0".
std::string mesh_node(const std::string& mesh, int i, int j);

}  // namespace kusabi::problems
