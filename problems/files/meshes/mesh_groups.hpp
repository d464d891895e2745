// The groups of a mesh file as lists of nodes and faces.
#pragma once

#include <set>
#include <vector>

#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

/// The nodes of a group: those that it lists; if it lists none, those of its faces; if it has none,
/// those of its elements. By tag, but as listed, and along the curve where it is made of lines:
/// each curve from its end with the smaller tag on.
/// @return numbers among `MeshData::nodes`, each once
std::vector<int> group_nodes(const MeshData& mesh, const MeshGroup& group);

/// The corners of the faces that a group is made of, each in ascending order: of its faces, and of
/// its elements of one dimension less than the body.
std::set<std::vector<int>> group_faces(const MeshData& mesh, const MeshGroup& group, int dimension);

/// The nodes of a face of an element, in the order of `element_faces`.
std::vector<int> face_nodes(const MeshData& mesh, const MeshFace& face);

}  // namespace kusabi::problems
