// Groups of a mesh file as lists of nodes and faces.
#pragma once

#include <set>
#include <vector>

#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

/// The nodes of a group: the listed ones; if there are none, those of its faces; otherwise those of
/// its elements. The order is that of the list, otherwise by tag; for lines along the curve, each
/// curve from its end with the smaller tag on.
/// @return indices in `MeshData::nodes`, without repetitions
std::vector<int> group_nodes(const MeshData& mesh, const MeshGroup& group);

/// The vertices of the faces of a group, each in ascending order: of its faces, and of its elements
/// with a dimension one below that of the body.
std::set<std::vector<int>> group_faces(const MeshData& mesh, const MeshGroup& group, int dimension);

/// The nodes of a face of an element, in the order of `element_faces`.
std::vector<int> face_nodes(const MeshData& mesh, const MeshFace& face);

/// The faces of some elements that no other element of the mesh has.
std::vector<MeshFace> free_faces(const MeshData& mesh, const std::vector<int>& elements);

}  // namespace kusabi::problems
