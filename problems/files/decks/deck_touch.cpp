// Nearest places, and normals weighted with the sizes of the faces.
#include "problems/files/decks/deck_touch.hpp"

#include <cstddef>

#include "problems/files/meshes/mesh_groups.hpp"
#include "problems/structure/geometry/face_geometry.hpp"

namespace kusabi::problems {
namespace {

Eigen::MatrixXd places_of(const DeckDraft& draft, const std::vector<int>& nodes) {
  Eigen::MatrixXd places(draft.dimension(), static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = draft.places().col(nodes[i]);
  return places;
}

}  // namespace

std::vector<FaceNodes> faces_of_group(const DeckDraft& draft, const MeshGroup& group) {
  std::vector<FaceNodes> faces;
  for (const MeshFace& face : group.faces) faces.push_back(face_nodes(draft.mesh(), face));
  for (const int number : group.elements) {
    const MeshElement& element = draft.mesh().elements[static_cast<std::size_t>(number)];
    if (mesh_dimension(element.shape) == draft.dimension() - 1) faces.push_back(element.nodes);
  }
  return faces;
}

std::vector<Touch> touches(const DeckDraft& draft, const std::vector<int>& nodes,
                           const std::vector<FaceNodes>& faces) {
  std::vector<Touch> result;
  for (const int node : nodes) {
    const auto place = *nearest_place(draft.places(), faces, draft.places().col(node));
    result.push_back({place.distance, place.size});
  }
  return result;
}

std::optional<Eigen::VectorXd> normal_of_plane(const DeckDraft& draft, const MeshGroup& group) {
  constexpr double one_plane = 1e-9;
  std::optional<Eigen::VectorXd> common;
  const auto fits = [&](const Eigen::MatrixXd& face, const Eigen::VectorXd& inside) {
    for (int node = 0; node < static_cast<int>(face.cols()); ++node) {
      Eigen::VectorXd normal = face_normal(face, node);
      if (normal.dot(face.col(node) - inside) < 0) normal = -normal;
      if (!common) common = normal;
      if ((normal - *common).norm() > one_plane) return false;
    }
    return true;
  };
  for (const MeshFace& face : group.faces) {
    const MeshElement& element = draft.mesh().elements[static_cast<std::size_t>(face.element)];
    const Eigen::VectorXd inside = places_of(draft, element.nodes).rowwise().mean();
    if (!fits(places_of(draft, face_nodes(draft.mesh(), face)), inside)) return std::nullopt;
  }
  if (!group.faces.empty()) return common;
  for (const auto& face : faces_of_group(draft, group)) {
    const Eigen::MatrixXd places = places_of(draft, face);
    const Eigen::VectorXd inside =
        places.col(0) - (common ? *common : face_normal(places, 0));  // the same side of all
    if (!fits(places, inside)) return std::nullopt;
  }
  return common;
}

std::map<int, Eigen::VectorXd> normals_at_nodes(const DeckDraft& draft,
                                                const std::vector<FaceNodes>& faces) {
  std::map<int, Eigen::VectorXd> normals;
  for (const FaceNodes& face : faces) {
    const Eigen::MatrixXd places = places_of(draft, face);
    const double size = face_size(places);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [entry, is_new] =
          normals.try_emplace(face[i], Eigen::VectorXd::Zero(draft.dimension()));
      entry->second += size * face_normal(places, static_cast<int>(i));
    }
  }
  for (auto& [node, normal] : normals) normal.stableNormalize();
  return normals;
}

}  // namespace kusabi::problems
