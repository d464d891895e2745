// The problem file, section by section: which keys there are and what they mean.
#include "problems/files/structure_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/loads_file.hpp"
#include "problems/files/toml_reader.hpp"
#include "problems/structure/structure_check.hpp"
#include "problems/structure/structured_mesh.hpp"

namespace kusabi::problems {
namespace {

/// Fills a structure from the sections of one file. Nodes come first: all else names them.
class StructureFile {
 public:
  StructureFile(std::string_view text, const std::string& file) : reader_(text, file) {
    structure_.sources.file = file;
  }

  Structure read() &&;

 private:
  void header();
  void nodes();
  void meshes();
  void members();
  void elements();
  void supports();
  void contact();
  void loads();

  void add_node(const std::string& name, const Eigen::VectorXd& place,
                support::SourcePosition position);
  void mesh(const TomlTable& group);
  void refuse_unjoined(const std::vector<int>& edge, support::SourcePosition position) const;
  Quadrilateral material(const TomlTable& group) const;
  void add_element(Quadrilateral element, const std::array<int, 4>& nodes,
                   support::SourcePosition position, support::SourcePosition material);
  void member_group(const TomlTable& group);
  void element_group(const TomlTable& group);
  void support_group(const TomlTable& group);
  void contact_group(const TomlTable& group);
  int node(const TomlText& name) const;
  /// The nodes that an entry of a list names: one, or those of an edge of a mesh.
  std::vector<int> nodes_named(const TomlText& name) const;
  void axial_stiffness(const TomlTable& group, Member& bar,
                       support::SourcePosition& position) const;
  std::array<bool, 3> fixed_axes(const TomlTable& group) const;

  bool has(std::string_view section) const { return reader_.root().table->get(section) != nullptr; }

  TomlReader reader_;
  Structure structure_;
  std::map<std::string, int, std::less<>> node_numbers_;
  std::map<std::string, std::vector<int>, std::less<>> edges_;  // of the meshes
  std::map<int, support::SourcePosition> supported_;
};

Structure StructureFile::read() && {
  reader_.allow_only(reader_.root(), {"name", "dimension", "units", "nodes", "mesh", "members",
                                      "elements", "supports", "contact", "loads", "uncertainty"});
  header();
  nodes();
  meshes();
  members();
  elements();
  supports();
  contact();
  structure_.coordinates.conservativeResize(
      Eigen::NoChange, static_cast<Eigen::Index>(structure_.node_names.size()));
  loads();
  check_structure(structure_);
  return std::move(structure_);
}

void StructureFile::header() {
  const TomlTable root = reader_.root();
  structure_.name = reader_.text(reader_.require(root, "name", "name = \"...\""), "name").text;
  structure_.dimension =
      reader_.one_of(reader_.require(root, "dimension", "2 or 3"), "dimension", {2, 3});
  const std::string_view pattern = "units = { length = \"...\", force = \"...\" }";
  const TomlTable units = reader_.table(reader_.require(root, "units", pattern), "units");
  reader_.allow_only(units, {"length", "force"});
  structure_.units.length =
      reader_.text(reader_.require(units, "length", pattern), "the unit of length").text;
  structure_.units.force =
      reader_.text(reader_.require(units, "force", pattern), "the unit of force").text;
}

void StructureFile::nodes() {
  structure_.coordinates.resize(structure_.dimension, 0);
  if (!has("nodes") && has("mesh")) return;
  const auto entries = reader_.entries(
      reader_.require(reader_.root(), "nodes", "a table [nodes] of name = position"), "[nodes]");
  for (const TomlEntry& entry : entries) {
    reader_.check_text(entry.key, "a node name", entry.key_position);
    add_node(entry.key,
             reader_.vector(*entry.value,
                            fmt::format("the position of node {}", support::in_quotes(entry.key)),
                            structure_.dimension),
             entry.key_position);
  }
}

void StructureFile::add_node(const std::string& name, const Eigen::VectorXd& place,
                             support::SourcePosition position) {
  const auto number = static_cast<int>(structure_.node_names.size());
  if (structure_.coordinates.cols() == number) {  // room for twice as many, cut off at the end
    structure_.coordinates.conservativeResize(Eigen::NoChange, 2 * number + 16);
  }
  structure_.coordinates.col(number) = place;
  structure_.fixed.push_back({false, false, false});
  structure_.node_names.push_back(name);
  structure_.sources.nodes.push_back(position);
  node_numbers_.emplace(name, number);
}

int StructureFile::node(const TomlText& name) const {
  const auto found = node_numbers_.find(name.text);
  if (found != node_numbers_.end()) return found->second;
  std::vector<std::string_view> names(structure_.node_names.begin(), structure_.node_names.end());
  for (const auto& [edge, nodes] : edges_) names.push_back(edge);
  std::string message = fmt::format("node {} does not exist; expected a name from [nodes]",
                                    support::in_quotes(name.text));
  const std::string_view meant = nearest(name.text, names);
  if (!meant.empty()) message += fmt::format("; did you mean {}?", support::in_quotes(meant));
  reader_.fail(name.position, message);
}

std::vector<int> StructureFile::nodes_named(const TomlText& name) const {
  const auto edge = edges_.find(name.text);
  if (edge != edges_.end()) return edge->second;
  return {node(name)};
}

void StructureFile::meshes() {
  if (!has("mesh")) return;
  for (const TomlTable& group : reader_.groups(*reader_.root().table->get("mesh"), "mesh")) {
    mesh(group);
  }
}

void StructureFile::mesh(const TomlTable& group) {
  if (structure_.dimension != 2) {
    reader_.fail(*group.table, "a mesh in space; expected dimension = 2, or members only");
  }
  reader_.allow_only(group, {"name", "corners", "divisions", "E", "nu", "thickness", "plane"});
  const auto& name_entry = reader_.require(group, "name", "name = \"...\", for its nodes");
  const TomlText name = reader_.text(name_entry, "the name of a mesh");
  const auto& corner_entry =
      reader_.require(group, "corners", "corners = [[x, y], ...], four of them, going round");
  const auto places = reader_.elements(corner_entry, "corners");
  if (places.size() != 4) {
    reader_.fail(
        corner_entry,
        fmt::format("a mesh has {} corners; expected four positions, going round", places.size()));
  }
  StructuredMesh mesh;
  for (int corner = 0; corner < 4; ++corner) {
    mesh.corners.col(corner) =
        reader_.vector(*places[static_cast<std::size_t>(corner)], "a corner", 2);
  }
  const auto& division_entry =
      reader_.require(group, "divisions",
                      "divisions = [11, 11], elements from left to right and "
                      "from bottom to top");
  const auto counts = reader_.elements(division_entry, "divisions");
  if (counts.size() != 2) {
    reader_.fail(division_entry,
                 fmt::format("divisions has {} entries; expected two", counts.size()));
  }
  mesh.columns = reader_.count(*counts[0], "a division", most_divisions);
  mesh.rows = reader_.count(*counts[1], "a division", most_divisions);
  if (!mesh.is_convex()) {
    reader_.fail(corner_entry,
                 "the corners of a mesh do not go round a convex quadrilateral; "
                 "expected lower left, lower right, upper right, upper left, or any "
                 "four like them");
  }
  const Quadrilateral material_of_all = material(group);

  std::vector<int> numbers;
  const auto old_nodes = static_cast<Eigen::Index>(structure_.node_names.size());
  for (int j = 0; j <= mesh.rows; ++j) {
    for (int i = 0; i <= mesh.columns; ++i) {
      const std::string node_name = mesh_node(name.text, i, j);
      const Eigen::Vector2d place = mesh.place(i, j);
      if (node_numbers_.contains(node_name) || edges_.contains(node_name)) {
        reader_.fail(name.position, fmt::format("the mesh makes a node {}, which exists already; "
                                                "expected another name for the mesh",
                                                support::in_quotes(node_name)));
      }
      const int same = mesh.node_at(structure_.coordinates.leftCols(old_nodes), place);
      if (same >= 0) {  // the meshes hang together there, and the node has two names
        node_numbers_.emplace(node_name, same);
        numbers.push_back(same);
      } else {
        numbers.push_back(static_cast<int>(structure_.node_names.size()));
        add_node(node_name, place, name.position);
      }
    }
  }
  for (const auto& [edge, nodes] : mesh.edges(numbers)) {
    const std::string edge_name = fmt::format("{}.{}", name.text, edge);
    if (node_numbers_.contains(edge_name)) {
      reader_.fail(name.position,
                   fmt::format("the mesh has an edge {}, which is the name of a node; "
                               "expected another name for the mesh",
                               support::in_quotes(edge_name)));
    }
    refuse_unjoined(nodes, name.position);
  }
  for (const auto& [edge, nodes] : mesh.edges(numbers))
    edges_.emplace(fmt::format("{}.{}", name.text, edge), nodes);
  for (const auto& nodes : mesh.elements(numbers)) {
    add_element(material_of_all, nodes, name.position, reader_.position(division_entry));
  }
}

// Meshes are joined where their nodes are, and nowhere else: two edges on one line with nodes at
// other places would gape there.
void StructureFile::refuse_unjoined(const std::vector<int>& edge,
                                    support::SourcePosition position) const {
  for (const auto& [other_name, other] : edges_) {
    int node = node_between(structure_.coordinates, other, edge);
    if (node < 0) node = node_between(structure_.coordinates, edge, other);
    if (node < 0) continue;
    reader_.fail(
        position,
        fmt::format("the mesh touches {} where their nodes do not meet: node {} lies "
                    "between two of the other; expected divisions that match, or a gap",
                    support::in_quotes(other_name),
                    support::in_quotes(structure_.node_names[static_cast<std::size_t>(node)])));
  }
}

Quadrilateral StructureFile::material(const TomlTable& group) const {
  Quadrilateral element{};
  element.modulus =
      reader_.number(reader_.require(group, "E", "E = Young's modulus, a force per area"), "E");
  element.ratio = reader_.number(reader_.require(group, "nu", "nu = Poisson's ratio"), "nu");
  element.thickness =
      reader_.number(reader_.require(group, "thickness", "thickness = a length"), "thickness");
  const auto& plane = reader_.require(group, "plane", "plane = \"stress\" or \"strain\"");
  const TomlText state = reader_.text(plane, "plane");
  if (state.text != "stress" && state.text != "strain") {
    reader_.fail(state.position, fmt::format("plane is {}; expected \"stress\" or \"strain\"",
                                             support::in_quotes(state.text)));
  }
  element.state = state.text == "stress" ? PlaneState::stress : PlaneState::strain;
  return element;
}

void StructureFile::add_element(Quadrilateral element, const std::array<int, 4>& nodes,
                                support::SourcePosition position,
                                support::SourcePosition material) {
  element.nodes = nodes;
  structure_.elements.push_back(element);
  structure_.sources.elements.push_back(position);
  structure_.sources.materials.push_back(material);
}

void StructureFile::elements() {
  if (!has("elements")) return;
  for (const TomlTable& group :
       reader_.groups(*reader_.root().table->get("elements"), "elements")) {
    element_group(group);
  }
}

void StructureFile::element_group(const TomlTable& group) {
  reader_.allow_only(group, {"E", "nu", "thickness", "plane", "between"});
  const Quadrilateral material_of_all = material(group);
  const auto& between =
      reader_.require(group, "between", "between = [[\"a\", \"b\", \"c\", \"d\"], ...]");
  for (const toml::node* corners : reader_.elements(between, "between")) {
    const auto names = reader_.texts(*corners, "an element");
    if (names.size() != 4) {
      reader_.fail(*corners, fmt::format("an element has {} corners; expected four node names, "
                                         "going round",
                                         names.size()));
    }
    add_element(material_of_all, {node(names[0]), node(names[1]), node(names[2]), node(names[3])},
                reader_.position(*corners), reader_.position(*group.table->get("E")));
  }
}

void StructureFile::members() {
  if (!has("members") && (has("elements") || has("mesh"))) return;
  const auto& section =
      reader_.require(reader_.root(), "members", "at least one [[members]] group");
  for (const TomlTable& group : reader_.groups(section, "members")) member_group(group);
}

void StructureFile::axial_stiffness(const TomlTable& group, Member& bar,
                                    support::SourcePosition& position) const {
  const toml::node* entry = group.table->get("EA");
  position = reader_.position(entry == nullptr ? *group.table : *entry);
  if (entry == nullptr) return;
  bar.axial_stiffness = reader_.number(*entry, "EA");
  // Zero would mean that none is given.
  if (bar.axial_stiffness == 0) reader_.fail(position, axial_stiffness_fault(0));
}

void StructureFile::member_group(const TomlTable& group) {
  reader_.allow_only(group, {"EA", "yield", "between"});
  Member bar{};
  support::SourcePosition stiffness_position;
  axial_stiffness(group, bar, stiffness_position);
  const toml::node* yield_entry = group.table->get("yield");
  if (yield_entry != nullptr) bar.yield = yield_in(reader_, *yield_entry);
  const support::SourcePosition yield_position =
      reader_.position(yield_entry == nullptr ? *group.table : *yield_entry);
  const auto& between = reader_.require(group, "between", "between = [[\"a\", \"b\"], ...]");
  for (const toml::node* pair : reader_.elements(between, "between")) {
    const auto ends = reader_.texts(*pair, "a member");
    if (ends.size() != 2) {
      reader_.fail(*pair, fmt::format("a member has {} ends; expected two node names, [\"a\", "
                                      "\"b\"]",
                                      ends.size()));
    }
    bar.first = node(ends[0]);
    bar.second = node(ends[1]);
    structure_.members.push_back(bar);
    structure_.sources.members.push_back(reader_.position(*pair));
    structure_.sources.axial_stiffnesses.push_back(stiffness_position);
    structure_.sources.yields.push_back(yield_position);
  }
}

void StructureFile::supports() {
  const auto& section =
      reader_.require(reader_.root(), "supports", "at least one [[supports]] group");
  for (const TomlTable& group : reader_.groups(section, "supports")) support_group(group);
}

std::array<bool, 3> StructureFile::fixed_axes(const TomlTable& group) const {
  const toml::node* entry = group.table->get("fixed");
  if (entry != nullptr) return axes_in(reader_, *entry, "fixed", structure_.dimension);
  std::array<bool, 3> fixed{};
  std::fill_n(fixed.begin(), structure_.dimension, true);
  return fixed;
}

void StructureFile::support_group(const TomlTable& group) {
  reader_.allow_only(group, {"nodes", "fixed"});
  const auto& names = reader_.require(group, "nodes", "nodes = [\"a\", ...]");
  const std::array<bool, 3> fixed = fixed_axes(group);
  for (const TomlText& name : reader_.texts(names, "nodes")) {
    for (const int number : nodes_named(name)) {
      const auto [before, is_new] = supported_.emplace(number, name.position);
      if (!is_new) {
        reader_.fail(
            name.position,
            fmt::format("node {} is supported twice, first on line {}; expected once",
                        support::in_quotes(structure_.node_names[static_cast<std::size_t>(number)]),
                        before->second.line));
      }
      structure_.fixed[static_cast<std::size_t>(number)] = fixed;
    }
  }
}

void StructureFile::contact() {
  const toml::node* section = reader_.root().table->get("contact");
  if (section == nullptr) return;
  for (const TomlTable& group : reader_.groups(*section, "contact")) contact_group(group);
}

void StructureFile::loads() {
  const toml::node* section = reader_.root().table->get("loads");
  const LoadsFile file(reader_, [this](const TomlText& name) { return node(name); });
  if (section != nullptr) file.read_loads(*section, structure_);
  section = reader_.root().table->get("uncertainty");
  if (section != nullptr) file.read_uncertainty(*section, structure_);
}

void StructureFile::contact_group(const TomlTable& group) {
  reader_.allow_only(group, {"nodes", "normal", "tangent", "friction"});
  const auto& names = reader_.require(group, "nodes", "nodes = [\"a\", ...]");
  const auto& normal_entry =
      reader_.require(group, "normal", "normal = [...], the outward normal of the obstacle");
  const Eigen::VectorXd direction =
      reader_.vector(normal_entry, "the normal", structure_.dimension);
  if (direction.isZero(0.0)) {
    reader_.fail(normal_entry, "the normal is zero; expected the outward normal of the obstacle");
  }
  const Eigen::VectorXd normal = direction.stableNormalized();
  const toml::node* tangent_entry = group.table->get("tangent");
  std::optional<Eigen::VectorXd> tangent;
  support::SourcePosition tangent_position;
  if (tangent_entry != nullptr) {
    tangent = reader_.vector(*tangent_entry, "the tangent", structure_.dimension);
    tangent_position = reader_.position(*tangent_entry);
  }
  double friction = 1;
  support::SourcePosition friction_position;
  if (const toml::node* entry = group.table->get("friction"); entry != nullptr) {
    friction = reader_.number(*entry, "friction");
    friction_position = reader_.position(*entry);
  }
  for (const TomlText& name : reader_.texts(names, "nodes")) {
    for (const int number : nodes_named(name)) {
      structure_.contact.push_back({number, normal, tangent, friction, direction});
      structure_.sources.contact.push_back(name.position);
      structure_.sources.normals.push_back(reader_.position(normal_entry));
      structure_.sources.tangents.push_back(tangent_position);
      structure_.sources.frictions.push_back(friction_position);
    }
  }
}

}  // namespace

Structure read_structure(std::string_view toml_text, const std::string& file_name) {
  if (toml_text.empty()) {
    throw support::InputError(file_name, {1, 1},
                              "the file is empty; expected a problem file in TOML");
  }
  return StructureFile(toml_text, file_name).read();
}

std::string file_text(const std::filesystem::path& file) {
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  if (!failure && size > largest_file) {
    throw support::InputError(
        file.string(), {},
        fmt::format("the file has {} bytes; expected at most {}", size, largest_file));
  }
  std::ifstream stream(file, std::ios::binary);
  if (failure || !stream) {
    throw support::InputError(file.string(), {},
                              "the file cannot be read; expected a problem file in TOML");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

Structure load_structure(const std::filesystem::path& file) {
  return read_structure(file_text(file), file.string());
}

}  // namespace kusabi::problems
