// Positions of surfaces of a family that contain all vertices of a face of the body. A single node
// is no criterion, since some surface of the family contains it.
#include "problems/files/draft/obstacle_place.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <fmt/format.h>

namespace kusabi::problems {
namespace {

/// Nodes at a larger distance, relative to the extent of the candidates, are not on the surface:
/// angles and axes are typed with three digits.
constexpr double visible_distance = 1e-3;

/// Minimum cosine of the angle between a face and the obstacle for contact.
constexpr double facing = 0.5;

double extent_of(const ProblemDraft& draft, const std::vector<ListedNode>& nodes) {
  const auto& places = draft.structure().coordinates;
  Eigen::VectorXd minimum = places.col(nodes.front().node);
  Eigen::VectorXd maximum = minimum;
  for (const auto& each : nodes) {
    minimum = minimum.cwiseMin(places.col(each.node));
    maximum = maximum.cwiseMax(places.col(each.node));
  }
  return (maximum - minimum).maxCoeff();
}

/// Offsets of the surfaces that contain faces at the nodes facing the obstacle, increasing.
std::vector<double> offsets_of_faces(const Surface& body, const ParallelSurfaces& surfaces,
                                     const std::vector<ListedNode>& nodes, double tolerance) {
  std::vector<double> offsets;
  for (const auto& each : nodes) {
    const Eigen::VectorXd towards = -surfaces.normal(each).stableNormalized();
    for (const int number : body.faces_at(each.node)) {
      if (body.normal(number, each.node).normalized().dot(towards) < facing) continue;
      const auto& face = body.faces()[static_cast<std::size_t>(number)];
      std::vector<double> vertices;
      for (const int node : std::span(face.nodes).first(static_cast<std::size_t>(face.vertices)))
        vertices.push_back(surfaces.offset(node));
      const auto [minimum, maximum] = std::ranges::minmax(vertices);
      if (maximum - minimum <= tolerance) offsets.push_back((minimum + maximum) / 2);
    }
  }
  std::ranges::sort(offsets);
  return offsets;
}

double distance(const std::vector<double>& offsets, double offset) {
  const auto next = std::ranges::lower_bound(offsets, offset);
  double minimum = next == offsets.end() ? INFINITY : *next - offset;
  if (next != offsets.begin()) minimum = std::min(minimum, offset - *std::prev(next));
  return minimum;
}

}  // namespace

std::optional<std::string> place_fault(const ProblemDraft& draft, const Surface& body,
                                       const ParallelSurfaces& surfaces,
                                       const std::vector<ListedNode>& nodes) {
  if (nodes.empty()) return {};
  const double tolerance = visible_distance * extent_of(draft, nodes);
  auto offsets = offsets_of_faces(body, surfaces, nodes, tolerance);
  const bool none = offsets.empty();
  std::vector<double> own;
  own.reserve(nodes.size());
  for (const auto& each : nodes) own.push_back(surfaces.offset(each.node));
  if (none) {
    auto sorted = own;
    std::ranges::sort(sorted);
    offsets.push_back(sorted[sorted.size() / 2]);
  }
  std::size_t off = 0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (distance(offsets, own[i]) > tolerance) ++off;
    if (distance(offsets, own[i]) > distance(offsets, own[worst])) worst = i;
  }
  if (off == 0) return {};
  return fmt::format(
      "{} of {} candidates are not on {} {}: they are up to {:.3g} {} off it, {} the farthest{}; "
      "expected the plane, cylinder or cone that the nodes are on, or normal = \"surface\"",
      off, nodes.size(), none ? "one" : "a", surfaces.called, distance(offsets, own[worst]),
      draft.structure().units.length, draft.node_name(nodes[worst].node),
      none ? ", nor is any face of the body, so the normal is wrong for all candidates" : "");
}

}  // namespace kusabi::problems
