// Mesh as its file has it, independent of the program that wrote it: nodes, elements of all kinds,
// groups, and materials and supports of Abaqus files. Plain data; the problem file determines which
// elements are the body and which only name parts of its surface.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Place of an entry: index in `MeshData::files`, and line.
struct MeshPlace {
  int file = 0;
  int line = 0;
};

/// Elements of a file, with the order of nodes of `ElementShape`. Points, lines and, in space,
/// triangles and quadrilaterals name parts of the surface.
enum class MeshShape {
  point,
  line2,
  line3,
  triangle3,
  triangle6,
  quadrilateral4,
  quadrilateral8,
  tetrahedron4,
  tetrahedron10,
  hexahedron8,
  hexahedron20,
};

/// Dimension of a shape, 0 to 3.
int mesh_dimension(MeshShape shape);
int mesh_nodes(MeshShape shape);
int mesh_corners(MeshShape shape);
/// Name of a shape in messages: "a triangle of 6 nodes".
std::string_view mesh_called(MeshShape shape);
/// The element shape of triangles, quadrilaterals, tetrahedra and hexahedra.
ElementShape element_shape(MeshShape shape);

struct MeshNode {
  int tag;
  Eigen::Vector3d place;  ///< length, in the unit of the mesh
  MeshPlace at;
};

struct MeshElement {
  int tag;
  MeshShape shape;
  std::vector<int> nodes;           ///< indices in `MeshData::nodes`
  std::optional<PlaneState> state;  ///< specified by some types (CPS4, CPE4)
  MeshPlace at;
};

/// A face of an element, as an index of `element_faces`.
struct MeshFace {
  int element;
  int face;
};

struct MeshGroup {
  std::string name;
  MeshPlace at;
  std::vector<int> nodes;  ///< explicitly listed nodes
  std::vector<int> elements;
  std::vector<MeshFace> faces;
};

/// The material of some elements.
struct MeshSection {
  std::vector<int> elements;
  double modulus;
  double ratio;
  double measure;  ///< thickness of plane elements, area of bars, in the unit of the mesh
  MeshPlace at;
};

struct MeshSupport {
  int node;
  std::array<bool, 3> fixed;
  MeshPlace at;
};

struct MeshData {
  std::vector<std::string> files;     ///< names: the requested file, then included ones
  std::vector<MeshNode> nodes;        ///< by tag
  std::vector<MeshElement> elements;  ///< by tag
  std::vector<MeshGroup> groups;
  std::vector<MeshSection> sections;
  std::vector<MeshSupport> supports;
  std::vector<std::string> warnings;  ///< ignored entries, a line each
};

}  // namespace kusabi::problems
