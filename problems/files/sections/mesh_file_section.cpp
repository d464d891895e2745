// Nodes, elements, groups and supports of the structure from a mesh, in this order.
#include "problems/files/sections/mesh_file_section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "problems/files/draft/mesh_body.hpp"
#include "problems/files/draft/mesh_file.hpp"
#include "problems/files/meshes/mesh_data.hpp"
#include "problems/files/meshes/mesh_groups.hpp"
#include "problems/files/sections/problem_sections.hpp"
#include "problems/files/toml/toml_text.hpp"
#include "problems/structure/geometry/mesh_joints.hpp"
#include "problems/structure/geometry/structured_mesh.hpp"

namespace kusabi::problems {
namespace {

/// Maximum length of the name of a node or a group in problem files.
constexpr std::size_t longest_name = 64;

/// Conversion of one [[mesh]].
class MeshFileSection {
 public:
  MeshFileSection(ProblemDraft& draft, const TomlTable& group, MeshPlan& plan);

  void read();

 private:
  void head(const TomlTable& group);
  void add_nodes();
  void check_plane() const;
  double size() const;
  void add_elements();
  void add_body_element(const MeshElement& element, const MeshUse& use);
  void add_bar(const MeshElement& element, const MeshUse& use);
  void add_group(const MeshGroup& group);
  void add_supports();

  support::SourcePosition position(MeshPlace at) const {
    return {at.line, 1, files_[static_cast<std::size_t>(at.file)]};
  }
  [[noreturn]] void fail(MeshPlace at, const std::string& message) const {
    fail_in_mesh(mesh_, at, message);
  }
  void warn(MeshPlace at, const std::string& message) {
    structure().warnings.emplace_back(structure_error(structure(), position(at), message).what());
  }
  /// Number in the structure; -1 for ignored nodes.
  int number(int node) const { return numbers_[static_cast<std::size_t>(node)]; }
  std::vector<int> numbers(const std::vector<int>& nodes) const;
  Structure& structure() { return draft_.structure(); }

  ProblemDraft& draft_;
  MeshPlan& plan_;
  MeshData mesh_;
  TomlText name_;
  double scale_ = 1;
  bool join_ = true;
  bool supports_ = true;              // those of the file are used
  std::optional<GroupMaterial> own_;  // of the elements without any other material
  std::vector<int> files_;            // indices of `mesh_.files` in the sources
  std::vector<MeshUse> uses_;         // by element
  std::vector<bool> used_;            // by node: whether it belongs to the body or a bar
  std::vector<int> numbers_;          // by node
  int first_element_ = 0;
};

MeshFileSection::MeshFileSection(ProblemDraft& draft, const TomlTable& group, MeshPlan& plan)
    : draft_(draft), plan_(plan) {
  head(group);
  const TomlText file = mesh_file_name(draft.reader(), *group.table->get("file"));
  mesh_ = read_mesh_file(draft.meshes(), MeshTexts::place("", file.text));
  for (const auto& each : mesh_.files) files_.push_back(draft.add_file(each));
  auto& warnings = draft.structure().warnings;
  warnings.insert(warnings.end(), mesh_.warnings.begin(), mesh_.warnings.end());
}

void MeshFileSection::head(const TomlTable& group) {
  const TomlReader& reader = draft_.reader();
  reader.allow_only(group, {"name", "file", "scale", "join", "supports", "E", "nu", "thickness",
                            "plane", "density", "expansion"});
  name_ = reader.text(reader.require(group, "name", "name = \"...\", for its nodes"),
                      "the name of a mesh");
  if (const auto* entry = group.table->get("scale"); entry != nullptr) {
    scale_ = reader.number(*entry, "scale");
    if (!(scale_ > 0)) {
      reader.fail(*entry, "scale is not positive; expected the length of one mesh unit");
    }
  }
  join_ = truth_of(reader, group, "join");
  supports_ = truth_of(reader, group, "supports");
  for (const char* key : {"E", "nu", "thickness", "plane", "density", "expansion"}) {
    if (!own_ && group.table->contains(key)) own_ = body_material(draft_, group);
  }
}

void MeshFileSection::read() {
  uses_ = mesh_uses(draft_, mesh_, name_.text, plan_.materials);
  for (const MeshGroup& group : mesh_.groups)
    if (!group.elements.empty()) plan_.element_groups.push_back(name_.text + "." + group.name);
  first_element_ = static_cast<int>(structure().elements.size());
  add_nodes();
  add_elements();
  for (const MeshGroup& group : mesh_.groups) add_group(group);
  if (supports_) {
    add_supports();
    if (!mesh_.pairs.empty()) {
      warn(mesh_.pairs.front().at,
           "contact pairs and ties are left out: kusabi import writes a problem file with them");
    }
    if (!mesh_.loads.empty() || !mesh_.gravity.empty()) {
      warn(mesh_.loads.empty() ? mesh_.gravity.front().at : mesh_.loads.front().at,
           "loads are left out: kusabi import writes a problem file with them");
    }
  }
  const auto first = static_cast<std::size_t>(first_element_);
  NamedMesh made{{}, first, structure().elements.size() - first};
  std::ranges::copy_if(numbers_, std::back_inserter(made.nodes),
                       [](int node) { return node >= 0; });
  draft_.add_mesh(name_.text, std::move(made));
  refuse_gapes(draft_, first_element_, plan_);
}

double MeshFileSection::size() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Eigen::Vector3d minimum = Eigen::Vector3d::Constant(infinity);
  Eigen::Vector3d maximum = -minimum;
  for (std::size_t i = 0; i < used_.size(); ++i) {
    if (!used_[i]) continue;
    minimum = minimum.cwiseMin(mesh_.nodes[i].place);
    maximum = maximum.cwiseMax(mesh_.nodes[i].place);
  }
  return (maximum - minimum).maxCoeff();
}

void MeshFileSection::check_plane() const {
  if (draft_.structure().dimension == 3) return;
  const double tolerance = same_place * size();
  for (std::size_t i = 0; i < used_.size(); ++i) {
    const MeshNode& node = mesh_.nodes[i];
    if (!used_[i] || std::abs(node.place.z()) <= tolerance) continue;
    fail(node.at, fmt::format("node {} has z = {:g}; expected 0 in a mesh in the plane",
                              mesh_name(mesh_, node), node.place.z()));
  }
}

// Nodes without elements, such as the centres of arcs in Gmsh files, are ignored.
void MeshFileSection::add_nodes() {
  used_.assign(mesh_.nodes.size(), false);
  for (std::size_t i = 0; i < uses_.size(); ++i) {
    if (uses_[i].role == MeshUse::Role::name) continue;
    for (const int node : mesh_.elements[i].nodes) used_[static_cast<std::size_t>(node)] = true;
  }
  check_plane();
  std::vector<int> older;
  for (int node = 0; join_ && node < draft_.node_count(); ++node) {
    if (!plan_.apart.contains(node)) older.push_back(node);
  }
  const NodeIndex places(structure().coordinates.leftCols(draft_.node_count()), older);
  const double tolerance = same_place * scale_ * size();
  std::set<int> taken;
  numbers_.assign(mesh_.nodes.size(), -1);
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (!used_[i]) continue;
    const MeshNode& node = mesh_.nodes[i];
    const std::string name = fmt::format("{}.{}", name_.text, mesh_name(mesh_, node));
    if (name.size() > longest_name || draft_.names_node(name) || draft_.names_group(name)) {
      draft_.reader().fail(name_.position,
                           fmt::format("the mesh makes a node {}, which exists already or is too "
                                       "long; expected another name for the mesh",
                                       support::in_quotes(name)));
    }
    const Eigen::VectorXd place = scale_ * node.place.head(structure().dimension);
    const int same = places.node_at(place, tolerance);
    if (same >= 0 && !taken.insert(same).second) {
      fail(node.at, fmt::format("node {} is a second one at the position of {}, to which it would "
                                "be joined; expected join = false, or one node there",
                                mesh_name(mesh_, node), draft_.node_name(same)));
    }
    if (same >= 0) draft_.add_name(name, same);
    numbers_[i] = same >= 0 ? same : draft_.add_node(name, place, position(node.at));
    if (!join_) plan_.apart.insert(numbers_[i]);
  }
}

std::vector<int> MeshFileSection::numbers(const std::vector<int>& nodes) const {
  std::vector<int> result;
  result.reserve(nodes.size());
  for (const int node : nodes) result.push_back(number(node));
  return result;
}

void MeshFileSection::add_elements() {
  for (std::size_t i = 0; i < uses_.size(); ++i) {
    if (uses_[i].role == MeshUse::Role::body) add_body_element(mesh_.elements[i], uses_[i]);
    if (uses_[i].role == MeshUse::Role::bar) add_bar(mesh_.elements[i], uses_[i]);
  }
}

void MeshFileSection::add_body_element(const MeshElement& element, const MeshUse& use) {
  Element made{};
  support::SourcePosition material_position;
  bool has_plane = structure().dimension == 3;
  const GroupMaterial* material = use.material;
  const bool has_section = use.section != nullptr && use.section->fault.empty();
  if (material == nullptr && !has_section && own_) material = &*own_;
  if (material != nullptr) {
    made = material->element;
    has_plane = has_plane || material->has_plane;
    material_position = material->position;
  } else if (has_section) {
    made.modulus = use.section->modulus;
    made.ratio = use.section->ratio;
    made.thickness = structure().dimension == 3 ? 1 : scale_ * use.section->measure;
    made.density = use.section->density;
    if (made.density == 0 && own_) made.density = own_->element.density;
    if (own_) made.expansion = own_->element.expansion;
    material_position = position(use.section->at);
  } else if (!is_of_stiffness(draft_, name_.text)) {
    refuse_misspelt(draft_, plan_.materials, plan_.element_groups, name_.text);
    const std::string fault = use.section == nullptr ? "" : ": " + use.section->fault;
    fail(element.at, fmt::format("element {} has no material{}; expected E and nu in the [[mesh]], "
                                 "or a [[material]] of a group that it is of",
                                 mesh_name(mesh_, element), fault));
  }
  if (element.state && material != nullptr && material->has_plane && made.state != *element.state) {
    fail(element.at, fmt::format("element {} differs from its material in plane stress or plane "
                                 "strain; expected the same, or a material without plane",
                                 mesh_name(mesh_, element)));
  }
  if (!has_plane && !element.state && !is_of_stiffness(draft_, name_.text)) {
    fail(element.at, fmt::format("element {} is neither in plane stress nor in plane strain; "
                                 "expected plane = \"stress\" or \"strain\" with its material",
                                 mesh_name(mesh_, element)));
  }
  if (element.state) made.state = *element.state;
  made.shape = element_shape(element.shape);
  add_element(draft_, std::move(made), numbers(element.nodes), position(element.at),
              material_position);
  plan_.joined.resize(structure().elements.size(), join_);
}

void MeshFileSection::add_bar(const MeshElement& element, const MeshUse& use) {
  Member bar{};
  support::SourcePosition material_position;
  if (use.material != nullptr) {
    bar = use.material->bar;
    material_position = use.material->position;
  } else {  // force per area times an area, whose unit is that of the mesh
    const double area = use.section->measure * scale_ * scale_;
    bar.axial_stiffness = use.section->modulus * area;
    bar.mass = use.section->density * area;
    if (bar.mass == 0 && own_) bar.mass = own_->element.density * area;
    if (own_) bar.expansion = own_->element.expansion;
    material_position = position(use.section->at);
  }
  bar.first = number(element.nodes[0]);
  bar.second = number(element.nodes[1]);
  auto& sources = structure().sources;
  structure().members.push_back(bar);
  sources.members.push_back(position(element.at));
  sources.axial_stiffnesses.push_back(material_position);
  sources.yields.push_back(material_position);
}

void MeshFileSection::add_group(const MeshGroup& group) {
  const std::string name = fmt::format("{}.{}", name_.text, group.name);
  const bool is_printable = std::ranges::none_of(group.name, is_control);
  if (name.size() > longest_name || !is_printable) {
    fail(group.at, fmt::format("group {} has a name that is too long, or no text; expected at most "
                               "{} bytes with that of the mesh",
                               support::in_quotes(group.name), longest_name));
  }
  if (draft_.names_node(name) || draft_.names_group(name)) {
    fail(group.at, fmt::format("group {} has the name of a node or of another group; expected "
                               "another name",
                               support::in_quotes(name)));
  }
  NamedGroup named;
  for (const int node : group_nodes(mesh_, group)) {
    if (number(node) >= 0) named.nodes.push_back(number(node));
  }
  // Abaqus files have sets of reference points and of rigid elements.
  if (named.nodes.empty() && is_abaqus_file(mesh_.files.front())) {
    warn(group.at, fmt::format("group {} has no node of an element and is left out",
                               support::in_quotes(group.name)));
    return;
  }
  if (named.nodes.empty()) {
    fail(group.at, fmt::format("group {} has no node of an element; expected nodes of the body",
                               support::in_quotes(group.name)));
  }
  for (const auto& face : group_faces(mesh_, group, structure().dimension)) {
    auto vertices = numbers(face);
    std::ranges::sort(vertices);
    named.faces.insert(std::move(vertices));
  }
  draft_.add_group(name, std::move(named));
}

void MeshFileSection::add_supports() {
  for (const MeshSupport& support : mesh_.supports) {
    auto fixed = support.fixed;
    if (structure().dimension == 2) fixed[2] = false;
    if (number(support.node) < 0) {
      const MeshNode& node = mesh_.nodes[static_cast<std::size_t>(support.node)];
      warn(support.at, fmt::format("the support of node {} is left out: no element has this node",
                                   mesh_name(mesh_, node)));
    } else if (fixed[0] || fixed[1] || fixed[2]) {
      draft_.support({number(support.node), position(support.at)}, fixed);
    }
  }
}

}  // namespace

void read_mesh_of_file(ProblemDraft& draft, const TomlTable& group, MeshPlan& plan) {
  MeshFileSection(draft, group, plan).read();
}

}  // namespace kusabi::problems
