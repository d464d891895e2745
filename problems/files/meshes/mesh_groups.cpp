// Nodes of groups; curves in their order.
#include "problems/files/meshes/mesh_groups.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "problems/structure/geometry/element_faces.hpp"

namespace kusabi::problems {
namespace {

const MeshElement& element_of(const MeshData& mesh, int number) {
  return mesh.elements[static_cast<std::size_t>(number)];
}

/// The lines of a group at each node.
using Lines = std::multimap<int, int>;

/// The first unused line at `node`; -1 if there is none.
int next_line(const Lines& lines, const std::set<int>& taken, int node) {
  const auto [first, last] = lines.equal_range(node);
  for (auto entry = first; entry != last; ++entry) {
    if (!taken.contains(entry->second)) return entry->second;
  }
  return -1;
}

/// Adds the nodes of a curve from `start` on, along connected lines.
void walk(const MeshData& mesh, const Lines& lines, std::set<int>& taken, int start,
          std::vector<int>& nodes) {
  nodes.push_back(start);
  for (int node = start, line = 0; (line = next_line(lines, taken, node)) >= 0;) {
    taken.insert(line);
    const auto& own = element_of(mesh, line).nodes;
    node = own[0] == node ? own[1] : own[0];
    if (own.size() == 3) nodes.push_back(own[2]);
    nodes.push_back(node);
  }
}

std::vector<int> along_curves(const MeshData& mesh, const MeshGroup& group) {
  Lines lines;
  for (const int number : group.elements) {
    const auto& nodes = element_of(mesh, number).nodes;
    lines.emplace(nodes[0], number);
    lines.emplace(nodes[1], number);
  }
  std::vector<int> nodes;
  std::set<int> taken;
  for (const bool from_ends : {true, false}) {  // the remaining lines are closed curves
    for (auto entry = lines.begin(); entry != lines.end();
         entry = lines.upper_bound(entry->first)) {
      const bool is_end = lines.count(entry->first) != 2;
      while ((is_end || !from_ends) && next_line(lines, taken, entry->first) >= 0) {
        walk(mesh, lines, taken, entry->first, nodes);
      }
    }
  }
  std::set<int> seen;
  std::erase_if(nodes, [&](int node) { return !seen.insert(node).second; });
  return nodes;
}

}  // namespace

std::vector<int> face_nodes(const MeshData& mesh, const MeshFace& face) {
  const MeshElement& element = element_of(mesh, face.element);
  std::vector<int> nodes;
  for (const int place :
       element_faces(element_shape(element.shape))[static_cast<std::size_t>(face.face)]) {
    nodes.push_back(element.nodes[static_cast<std::size_t>(place)]);
  }
  return nodes;
}

std::vector<MeshFace> free_faces(const MeshData& mesh, const std::vector<int>& elements) {
  const auto for_faces = [&](int number, const auto& use) {
    const MeshElement& element = element_of(mesh, number);
    if (mesh_dimension(element.shape) < 2) return;
    const auto count = static_cast<int>(element_faces(element_shape(element.shape)).size());
    for (int face = 0; face < count; ++face) {
      auto nodes = face_nodes(mesh, {number, face});
      std::ranges::sort(nodes);
      use(MeshFace{number, face}, nodes);
    }
  };
  std::map<std::vector<int>, int> uses;
  for (int number = 0; number < static_cast<int>(mesh.elements.size()); ++number) {
    for_faces(number, [&](MeshFace, const std::vector<int>& nodes) { ++uses[nodes]; });
  }
  std::vector<MeshFace> result;
  for (const int number : elements) {
    for_faces(number, [&](MeshFace face, const std::vector<int>& nodes) {
      if (uses[nodes] == 1) result.push_back(face);
    });
  }
  return result;
}

std::vector<int> group_nodes(const MeshData& mesh, const MeshGroup& group) {
  if (!group.nodes.empty()) return group.nodes;
  std::set<int> nodes;
  for (const MeshFace& face : group.faces) {
    const auto more = face_nodes(mesh, face);
    nodes.insert(more.begin(), more.end());
  }
  if (!nodes.empty()) return {nodes.begin(), nodes.end()};
  const bool lines = std::ranges::all_of(group.elements, [&](int number) {
    return mesh_dimension(element_of(mesh, number).shape) == 1;
  });
  if (lines) return along_curves(mesh, group);
  for (const int number : group.elements) {
    const auto& more = element_of(mesh, number).nodes;
    nodes.insert(more.begin(), more.end());
  }
  return {nodes.begin(), nodes.end()};
}

std::set<std::vector<int>> group_faces(const MeshData& mesh, const MeshGroup& group,
                                       int dimension) {
  std::set<std::vector<int>> faces;
  const auto add = [&](std::vector<int> nodes, std::size_t vertices) {
    nodes.resize(vertices);
    std::ranges::sort(nodes);
    faces.insert(std::move(nodes));
  };
  for (const MeshFace& face : group.faces) {
    auto nodes = face_nodes(mesh, face);
    const auto all = nodes.size();  // vertices, and as many midpoints; an edge has one
    const bool straight = mesh_nodes(element_of(mesh, face.element).shape) ==
                          mesh_corners(element_of(mesh, face.element).shape);
    add(std::move(nodes), straight ? all : dimension == 2 ? 2 : all / 2);
  }
  for (const int number : group.elements) {
    const MeshElement& element = element_of(mesh, number);
    if (mesh_dimension(element.shape) != dimension - 1) continue;
    add(element.nodes, static_cast<std::size_t>(mesh_corners(element.shape)));
  }
  return faces;
}

}  // namespace kusabi::problems
