// Structured meshes: a quadrilateral given by its vertices and divided into elements.
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "problems/files/sections/mesh_file_section.hpp"
#include "problems/files/sections/problem_sections.hpp"
#include "problems/structure/geometry/structured_mesh.hpp"

namespace kusabi::problems {
namespace {

/// The edges of all meshes, by name.
using Edges = std::map<std::string, std::vector<int>, std::less<>>;

Eigen::Matrix<double, 2, 4> vertices(const TomlReader& reader, const toml::node& entry) {
  const auto places = reader.elements(entry, "corners");
  if (places.size() != 4) {
    reader.fail(entry, fmt::format("a mesh has {} corners; expected four positions, in order "
                                   "around the mesh",
                                   places.size()));
  }
  Eigen::Matrix<double, 2, 4> result;
  for (int vertex = 0; vertex < 4; ++vertex) {
    result.col(vertex) = reader.vector(*places[static_cast<std::size_t>(vertex)], "a corner", 2);
  }
  return result;
}

StructuredMesh shape(const TomlReader& reader, const TomlTable& group) {
  StructuredMesh mesh;
  const auto& corner_entry =
      reader.require(group, "corners",
                     "corners = [[x, y], ...], four of them, in order around "
                     "the mesh");
  mesh.vertices = vertices(reader, corner_entry);
  const auto& division_entry = reader.require(group, "divisions",
                                              "divisions = [11, 11], elements from left to right "
                                              "and from bottom to top");
  const auto counts = reader.elements(division_entry, "divisions");
  if (counts.size() != 2) {
    reader.fail(division_entry,
                fmt::format("divisions has {} entries; expected two", counts.size()));
  }
  mesh.columns = reader.count(*counts[0], "a division", max_divisions);
  mesh.rows = reader.count(*counts[1], "a division", max_divisions);
  if (!mesh.is_convex()) {
    reader.fail(corner_entry,
                "the corners of a mesh are not those of a convex quadrilateral in order; expected "
                "lower left, lower right, upper right, upper left, or four others in order around "
                "it");
  }
  return mesh;
}

/// Numbers of the nodes, row by row. A node that coincides with one of an earlier mesh is
/// identified with it and has two names, which connects the meshes.
std::vector<int> add_nodes(ProblemDraft& draft, const StructuredMesh& mesh, const TomlText& name,
                           bool join, MeshPlan& plan) {
  std::vector<int> numbers;
  const auto old_nodes = static_cast<Eigen::Index>(draft.node_count());
  for (int j = 0; j <= mesh.rows; ++j) {
    for (int i = 0; i <= mesh.columns; ++i) {
      const std::string node_name = mesh_node(name.text, i, j);
      const Eigen::Vector2d place = mesh.place(i, j);
      if (draft.names_node(node_name) || draft.names_group(node_name)) {
        draft.reader().fail(name.position,
                            fmt::format("the mesh makes a node {}, which exists already; expected "
                                        "another name for the mesh",
                                        support::in_quotes(node_name)));
      }
      const auto& places = draft.structure().coordinates;
      int same = join ? mesh.node_at(places.leftCols(old_nodes), place) : -1;
      if (plan.apart.contains(same)) same = -1;
      if (same >= 0) draft.add_name(node_name, same);
      numbers.push_back(same >= 0 ? same : draft.add_node(node_name, place, name.position));
      if (!join) plan.apart.insert(numbers.back());
    }
  }
  return numbers;
}

// Checks for gaps: meshes are joined at common nodes only, so two edges on one line with different
// nodes would not be connected.
void refuse_unjoined(const ProblemDraft& draft, const Edges& edges, const std::vector<int>& edge,
                     support::SourcePosition position) {
  const auto& places = draft.structure().coordinates;
  for (const auto& [other_name, other] : edges) {
    int node = node_between(places, other, edge);
    if (node < 0) node = node_between(places, edge, other);
    if (node < 0) continue;
    draft.reader().fail(
        position, fmt::format("the mesh touches {} where their nodes do not meet: node {} lies "
                              "between two of the other; expected divisions that match, or a gap",
                              support::in_quotes(other_name), draft.node_name(node)));
  }
}

void add_edges(ProblemDraft& draft, const StructuredMesh& mesh, const std::vector<int>& numbers,
               const TomlText& name, bool join, Edges& edges) {
  const auto own = mesh.edges(numbers);
  for (const auto& [edge, nodes] : own) {
    const std::string edge_name = fmt::format("{}.{}", name.text, edge);
    if (draft.names_node(edge_name)) {
      draft.reader().fail(name.position,
                          fmt::format("the mesh has an edge {}, which is the name of a node; "
                                      "expected another name for the mesh",
                                      support::in_quotes(edge_name)));
    }
    if (join) refuse_unjoined(draft, edges, nodes, name.position);
  }
  for (const auto& [edge, nodes] : own) {
    const std::string edge_name = fmt::format("{}.{}", name.text, edge);
    if (join) edges.emplace(edge_name, nodes);
    draft.add_group(edge_name, {nodes, {}});
  }
}

void structured_mesh(ProblemDraft& draft, const TomlTable& group, Edges& edges, MeshPlan& plan) {
  const TomlReader& reader = draft.reader();
  if (draft.structure().dimension != 2) {
    reader.fail(*group.table,
                "a mesh with corners is plane; expected dimension = 2, or file = \"...\" of a mesh "
                "in space");
  }
  reader.allow_only(group, {"name", "corners", "divisions", "join", "E", "nu", "thickness", "plane",
                            "density", "expansion"});
  const auto& name_entry = reader.require(group, "name", "name = \"...\", for its nodes");
  const TomlText name = reader.text(name_entry, "the name of a mesh");
  const StructuredMesh mesh = shape(reader, group);
  const Element material_of_all = material(reader, group, 2);
  const bool join = truth_of(reader, group, "join");
  const auto numbers = add_nodes(draft, mesh, name, join, plan);
  add_edges(draft, mesh, numbers, name, join, edges);
  const auto first_element = static_cast<int>(draft.structure().elements.size());
  const auto material_position = reader.position(*group.table->get("divisions"));
  for (const auto& nodes : mesh.elements(numbers)) {
    add_element(draft, material_of_all, {nodes.begin(), nodes.end()}, name.position,
                material_position);
  }
  plan.joined.resize(draft.structure().elements.size(), join);
  const auto first = static_cast<std::size_t>(first_element);
  draft.add_mesh(name.text, {numbers, first, draft.structure().elements.size() - first});
  const bool are_of_files = !draft.structure().sources.more_files.empty();
  if (are_of_files) refuse_gapes(draft, first_element, plan);
}

}  // namespace

void read_meshes(ProblemDraft& draft) {
  const toml::node* section = draft.section("mesh");
  if (section == nullptr) return;
  Edges edges;
  MeshPlan plan{.materials = read_materials(draft), .apart = {}, .joined = {}};
  for (const TomlTable& group : draft.reader().groups(*section, "mesh")) {
    if (group.table->contains("file")) {
      read_mesh_of_file(draft, group, plan);
    } else {
      structured_mesh(draft, group, edges, plan);
    }
  }
  require_all_found(draft, plan.materials, plan.element_groups);
}

}  // namespace kusabi::problems
