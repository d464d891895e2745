// Comparison of contact normals with the surface of the body.
#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/geometry/surface.hpp"

namespace kusabi::problems {
namespace {

/// Angle between the normal of each candidate and the surface, in degrees; nothing where there is
/// no surface: at bars and within the body.
std::vector<std::optional<double>> angles(const Structure& structure) {
  std::vector<std::optional<double>> result(structure.contact.size());
  if (body_elements(structure) == 0 || structure.contact.empty()) return result;
  const Surface surface(structure);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const ContactCandidate& candidate = structure.contact[i];
    std::vector<Eigen::VectorXd> normals;
    for (const int face : surface.faces_at(candidate.node)) {
      normals.push_back(surface.normal(face, candidate.node));
    }
    if (!normals.empty()) result[i] = angle_from_cone(normals, -candidate.normal);
  }
  return result;
}

std::string node_name(const Structure& structure, std::size_t candidate) {
  return quoted_name(structure, structure.contact[candidate].node);
}

}  // namespace

void check_normals(const Structure& structure) {
  const auto off = angles(structure);
  for (std::size_t i = 0; i < off.size(); ++i) {
    if (!off[i] || *off[i] < 90) continue;
    throw structure_error(
        structure, position_of(structure.sources.normals, static_cast<int>(i)),
        fmt::format("the normal at {} points out of the body, {:.1f} degrees off its surface; "
                    "expected the outward normal of the obstacle, into the body",
                    node_name(structure, i), *off[i]));
  }
}

std::vector<std::string> normal_warnings(const Structure& structure) {
  struct Off {
    int count = 0;
    std::size_t worst = 0;
  };
  const auto off = angles(structure);
  std::map<std::pair<int, int>, Off> by_place;
  for (std::size_t i = 0; i < off.size(); ++i) {
    if (!off[i] || *off[i] <= visible_angle) continue;
    const auto place = position_of(structure.sources.normals, static_cast<int>(i));
    auto [entry, is_new] = by_place.emplace(std::pair(place.line, place.column), Off{0, i});
    ++entry->second.count;
    if (*off[i] > *off[entry->second.worst]) entry->second.worst = i;
  }
  std::vector<std::string> lines;
  for (const auto& [place, found] : by_place) {
    const auto message =
        fmt::format("the normal is {:.1f} degrees off the surface of the body at {}{}",
                    *off[found.worst], node_name(structure, found.worst),
                    found.count == 1 ? ""
                                     : fmt::format(", and off by more than a degree at {} nodes in "
                                                   "all",
                                                   found.count));
    lines.emplace_back(structure_error(structure, {place.first, place.second}, message).what());
  }
  return lines;
}

}  // namespace kusabi::problems
