// Distances of the nodes of a surface from another one, and their normals.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "problems/files/decks/deck_draft.hpp"
#include "problems/structure/geometry/surface_place.hpp"

namespace kusabi::problems {

/// The faces of a group as nodes of the mesh: of its faces and of its elements that are surfaces.
std::vector<FaceNodes> faces_of_group(const DeckDraft& draft, const MeshGroup& group);

struct Touch {
  double distance;
  double size;  ///< of the nearest face
};

/// The distance of each node from the faces. @pre there are faces
std::vector<Touch> touches(const DeckDraft& draft, const std::vector<int>& nodes,
                           const std::vector<FaceNodes>& faces);

/// The mean unit normal of the faces at each of their nodes, of either sense.
std::map<int, Eigen::VectorXd> normals_at_nodes(const DeckDraft& draft,
                                                const std::vector<FaceNodes>& faces);

/// The unit normal of faces in one plane, out of their bodies if they are of any; nothing if they
/// are in several planes.
std::optional<Eigen::VectorXd> normal_of_plane(const DeckDraft& draft, const MeshGroup& group);

}  // namespace kusabi::problems
