// Mesh as its file has it, independent of the program that wrote it: nodes, elements of all kinds,
// groups, and materials and supports of Abaqus files. Plain data; the problem file determines which
// elements are the body and which only name parts of its surface.
#pragma once

#include <array>
#include <cstddef>
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
  prism6,
  prism15,
  pyramid5,
};

/// Dimension of a shape, 0 to 3.
int mesh_dimension(MeshShape shape);
int mesh_nodes(MeshShape shape);
int mesh_corners(MeshShape shape);
/// Name of a shape in messages: "a triangle of 6 nodes".
std::string_view mesh_called(MeshShape shape);
/// The element shape of triangles, quadrilaterals, tetrahedra, hexahedra, prisms and pyramids.
ElementShape element_shape(MeshShape shape);

struct MeshNode {
  int tag;
  Eigen::Vector3d place;  ///< length, in the unit of the mesh
  MeshPlace at;
  int instance = 0;     ///< index in `MeshData::instances`
  bool turned = false;  ///< supports of single axes are along axes of its own (*TRANSFORM)
};

struct MeshElement {
  int tag;
  MeshShape shape;
  std::vector<int> nodes;           ///< indices in `MeshData::nodes`
  std::optional<PlaneState> state;  ///< specified by some types (CPS4, CPE4)
  MeshPlace at;
  int instance = 0;
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
  std::string set;       ///< name of the group of these elements
  std::string material;  ///< its name
  std::string fault;   ///< empty, or why the modulus is not known: "material \"A\" is not elastic"
  double density = 0;  ///< mass per volume; zero if it is not given
};

struct MeshSupport {
  int node;
  std::array<bool, 3> fixed;
  MeshPlace at;
};

struct MeshLoad {
  int node;
  Eigen::Vector3d force;  ///< along the axes, in the unit of the file
  MeshPlace at;
};

/// Gravity on the elements of a group, or on all.
struct MeshGravity {
  std::string group;             ///< empty: all elements
  Eigen::Vector3d acceleration;  ///< in the units of the file
  MeshPlace at;
};

/// Two surfaces of a file that touch, or are tied.
struct MeshPair {
  std::string nodes;               ///< group of the nodes that touch the other surface
  std::string against;             ///< group; empty: an analytical rigid surface
  std::optional<double> friction;  ///< coefficient
  bool tied = false;
  /// Distance of nodes that count as touching, in the unit of the mesh.
  std::optional<double> tolerance;
  MeshPlace at;
};

struct MeshData {
  std::string heading;
  std::vector<std::string> files;  ///< names: the requested file, then included ones
  /// Names of the instances of an assembly, whose tags are independent. The first has no name: it
  /// is the assembly, or the whole of a file without instances.
  std::vector<std::string> instances{""};
  std::vector<MeshNode> nodes;        ///< by instance and tag
  std::vector<MeshElement> elements;  ///< by instance and tag
  std::vector<MeshGroup> groups;
  std::vector<MeshSection> sections;
  std::vector<MeshSupport> supports;
  std::vector<MeshLoad> loads;
  std::vector<MeshGravity> gravity;
  std::vector<MeshPair> pairs;
  std::vector<std::string> warnings;  ///< ignored entries, a line each
};

/// Name of a node or an element within the mesh: "17", or "peg-1.17" of an instance.
template <class Entry>
std::string mesh_name(const MeshData& mesh, const Entry& entry) {
  const std::string& instance = mesh.instances[static_cast<std::size_t>(entry.instance)];
  return (instance.empty() ? "" : instance + ".") + std::to_string(entry.tag);
}

}  // namespace kusabi::problems
