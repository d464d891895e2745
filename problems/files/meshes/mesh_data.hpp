// A mesh as its file has it, whichever program wrote it: nodes, elements of all kinds, groups, and
// what an Abaqus file says besides of materials and supports. Plain data: what is the body and what
// only names a part of its surface is for the problem file to say.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Where something of a mesh stands: which of `MeshData::files`, and its line.
struct MeshPlace {
  int file = 0;
  int line = 0;
};

/// Elements of a file, of the order of nodes that `ElementShape` has. Points, lines and, in space,
/// triangles and quadrilaterals serve as names of parts of the surface.
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

/// 0 to 3.
int mesh_dimension(MeshShape shape);
int mesh_nodes(MeshShape shape);
int mesh_corners(MeshShape shape);
/// "a triangle of 6 nodes".
std::string_view mesh_called(MeshShape shape);
/// Of triangles, quadrilaterals, tetrahedra and hexahedra.
ElementShape element_shape(MeshShape shape);

struct MeshNode {
  int tag;
  Eigen::Vector3d place;  ///< length, in the unit of the mesh
  MeshPlace at;
};

struct MeshElement {
  int tag;
  MeshShape shape;
  std::vector<int> nodes;           ///< numbers among `MeshData::nodes`
  std::optional<PlaneState> state;  ///< where the type says it (CPS4, CPE4)
  MeshPlace at;
};

/// A face of an element, by its number in `element_faces`.
struct MeshFace {
  int element;
  int face;
};

struct MeshGroup {
  std::string name;
  MeshPlace at;
  std::vector<int> nodes;  ///< those listed by themselves
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
  std::vector<std::string> files;     ///< their names: what was asked for, then what it includes
  std::vector<MeshNode> nodes;        ///< by tag
  std::vector<MeshElement> elements;  ///< by tag
  std::vector<MeshGroup> groups;
  std::vector<MeshSection> sections;
  std::vector<MeshSupport> supports;
  std::vector<std::string> warnings;  ///< what was left out, a line each
};

}  // namespace kusabi::problems
