// Reader of Abaqus input files, keyword by keyword.
#include "problems/files/meshes/abaqus_file.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/meshes/abaqus_groups.hpp"
#include "problems/files/meshes/abaqus_materials.hpp"
#include "problems/files/meshes/abaqus_text.hpp"
#include "problems/files/meshes/mesh_index.hpp"
#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

struct ElementType {
  std::string_view name;
  MeshShape shape;
  std::optional<PlaneState> state;
};

constexpr auto stress = PlaneState::stress;
constexpr auto strain = PlaneState::strain;

constexpr std::array<ElementType, 16> element_types{
    {{"CPS3", MeshShape::triangle3, stress},
     {"CPS4", MeshShape::quadrilateral4, stress},
     {"CPS6", MeshShape::triangle6, stress},
     {"CPS8", MeshShape::quadrilateral8, stress},
     {"CPE3", MeshShape::triangle3, strain},
     {"CPE4", MeshShape::quadrilateral4, strain},
     {"CPE6", MeshShape::triangle6, strain},
     {"CPE8", MeshShape::quadrilateral8, strain},
     {"C3D4", MeshShape::tetrahedron4, std::nullopt},
     {"C3D8", MeshShape::hexahedron8, std::nullopt},
     {"C3D10", MeshShape::tetrahedron10, std::nullopt},
     {"C3D20", MeshShape::hexahedron20, std::nullopt},
     {"T2D2", MeshShape::line2, std::nullopt},
     {"T3D2", MeshShape::line2, std::nullopt},
     {"T2D3", MeshShape::line3, std::nullopt},
     {"T3D3", MeshShape::line3, std::nullopt}}};

/// Keywords without influence on the stiffness of the body or its supports.
const std::set<std::string, std::less<>> left_out{
    "*STEP",        "*END STEP",     "*STATIC",        "*CLOAD",
    "*DLOAD",       "*DSLOAD",       "*NODE FILE",     "*NODE PRINT",
    "*NODE OUTPUT", "*EL FILE",      "*EL PRINT",      "*ELEMENT OUTPUT",
    "*OUTPUT",      "*CONTACT FILE", "*CONTACT PRINT", "*FILE FORMAT",
    "*DENSITY",     "*EXPANSION",    "*CONDUCTIVITY",  "*SPECIFIC HEAT",
    "*PREPRINT",    "*RESTART",      "*AMPLITUDE",     "*PHYSICAL CONSTANTS",
    "*TIME POINTS", "*MONITOR",      "*CONTROLS",      "*FREQUENCY",
    "*BUCKLE"};

/// Keywords of files written in parts, the default of Abaqus/CAE.
const std::set<std::string, std::less<>> of_parts{"*PART",     "*END PART",     "*ASSEMBLY",
                                                  "*INSTANCE", "*END INSTANCE", "*END ASSEMBLY"};

/// Keywords of contact, which is defined in the problem file.
const std::set<std::string, std::less<>> of_contact{"*SURFACE INTERACTION",
                                                    "*SURFACE BEHAVIOR",
                                                    "*FRICTION",
                                                    "*CONTACT PAIR",
                                                    "*CONTACT",
                                                    "*GAP CONDUCTANCE",
                                                    "*CONTACT CONTROLS",
                                                    "*CONTACT INCLUSIONS",
                                                    "*CONTACT PROPERTY ASSIGNMENT"};

class AbaqusFile {
 public:
  AbaqusFile(const MeshTexts& texts, const std::string& place) : text_(texts, place) {}

  MeshData read() &&;

 private:
  void read_card(const AbaqusCard& card);
  void leave_out(const AbaqusCard& card);
  void nodes(const AbaqusCard& card);
  void elements(const AbaqusCard& card);
  void element(const ElementType& type, std::vector<int>& numbers);
  void boundary(const AbaqusCard& card);
  std::array<bool, 3> fixed_here() const;

  AbaqusText text_;
  MeshData mesh_;
  MeshIndex index_{mesh_};
  AbaqusGroups groups_{mesh_, index_};
  AbaqusMaterials materials_{mesh_, groups_};
  std::map<int, MeshSupport> supports_;
};

MeshData AbaqusFile::read() && {
  AbaqusCard card;
  while (text_.next_card(card)) read_card(card);
  mesh_.files = text_.files();
  if (mesh_.nodes.empty()) text_.line().fail("the file has no *NODE; expected nodes");
  if (mesh_.elements.empty()) text_.line().fail("the file has no *ELEMENT; expected elements");
  materials_.finish();
  for (const auto& [node, support] : supports_) mesh_.supports.push_back(support);
  sort_by_tag(mesh_);
  return std::move(mesh_);
}

void AbaqusFile::read_card(const AbaqusCard& card) {
  const std::string& keyword = card.keyword;
  if (keyword == "*HEADING") {
    while (text_.next_data()) continue;
    return;
  }
  if (keyword == "*NODE") return nodes(card);
  if (keyword == "*ELEMENT") return elements(card);
  if (keyword == "*NSET") return groups_.read_node_set(text_, card);
  if (keyword == "*ELSET") return groups_.read_element_set(text_, card);
  if (keyword == "*SURFACE") return groups_.read_surface(text_, card);
  if (keyword == "*MATERIAL") return materials_.read_material(text_, card);
  if (keyword == "*ELASTIC") return materials_.read_elastic(text_, card);
  if (keyword == "*SOLID SECTION") return materials_.read_section(text_, card);
  if (keyword == "*BOUNDARY") return boundary(card);
  if (left_out.contains(keyword)) return leave_out(card);
  const auto refuse = [&](std::string_view why) {
    text_.line().fail(
        fmt::format("keyword {} is not understood: {}", support::in_quotes(keyword), why));
  };
  if (of_parts.contains(keyword)) {
    refuse(
        "flat decks are read, not parts and assemblies; expected one from Abaqus/CAE with Model, "
        "Edit Attributes, \"Do not use parts and assemblies in input files\"");
  }
  if (of_contact.contains(keyword)) {
    refuse(
        "flat decks of nodes, elements, sets, surfaces and materials are read; expected none of "
        "contact and friction, which [[contact]] of the problem file says and --mu, so leave "
        "this keyword and its data out");
  }
  text_.line().fail(
      fmt::format("keyword {} is not understood; expected *NODE, *ELEMENT, *NSET, "
                  "*ELSET, *SURFACE, *MATERIAL, *ELASTIC, *SOLID SECTION, *BOUNDARY, "
                  "*INCLUDE or *HEADING",
                  support::in_quotes(keyword)));
}

void AbaqusFile::leave_out(const AbaqusCard& card) {
  mesh_.warnings.push_back(
      fmt::format("{}:{}: {} is left out", text_.line().file(), card.at.line, card.keyword));
  while (text_.next_data()) continue;
}

void AbaqusFile::nodes(const AbaqusCard& card) {
  allow_only(text_, card, {"NSET"});
  std::vector<int> numbers;
  while (text_.next_data()) {
    const MeshText& line = text_.line();
    MeshNode node{line.whole(0, "the number of a node", 1), Eigen::Vector3d::Zero(), text_.here()};
    if (line.fields() < 3 || line.fields() > 4) {
      line.fail(
          fmt::format("a node with {} coordinates; expected two or three", line.fields() - 1));
    }
    for (std::size_t i = 1; i < line.fields(); ++i) {
      node.place(static_cast<Eigen::Index>(i) - 1) = line.real(i, "a coordinate");
    }
    numbers.push_back(static_cast<int>(mesh_.nodes.size()));
    index_.add_node(line, node);
  }
  if (const auto* set = card.find("NSET"); set != nullptr) {
    auto& all = groups_.group(text_, *set, card.at).nodes;
    all.insert(all.end(), numbers.begin(), numbers.end());
  }
}

void AbaqusFile::elements(const AbaqusCard& card) {
  allow_only(text_, card, {"TYPE", "ELSET"});
  const std::string name = capitals(required(text_, card, "TYPE"));
  const auto type = std::ranges::find(element_types, name, &ElementType::name);
  if (type == element_types.end()) {
    text_.line().fail(
        fmt::format("elements of type {} are not understood; expected CPS3, CPS4, "
                    "CPS6, CPS8, CPE3, CPE4, CPE6, CPE8, C3D4, C3D8, C3D10, C3D20, "
                    "T2D2 or T3D2",
                    support::in_quotes(name)));
  }
  std::vector<int> numbers;
  while (text_.next_data()) element(*type, numbers);
  if (const auto* set = card.find("ELSET"); set != nullptr) {
    auto& all = groups_.group(text_, *set, card.at).elements;
    all.insert(all.end(), numbers.begin(), numbers.end());
  }
}

// The nodes of an element may take several lines.
void AbaqusFile::element(const ElementType& type, std::vector<int>& numbers) {
  MeshElement element{text_.line().whole(0, "the number of an element", 1),
                      type.shape,
                      {},
                      type.state,
                      text_.here()};
  const auto count = static_cast<std::size_t>(mesh_nodes(type.shape));
  std::size_t first = 1;
  while (true) {
    const MeshText& line = text_.line();
    for (std::size_t i = first; i < line.fields(); ++i) {
      if (element.nodes.size() == count) {
        line.fail(
            i, fmt::format("more nodes than {} has; expected {}", mesh_called(type.shape), count));
      }
      element.nodes.push_back(index_.node(line, i));
    }
    if (element.nodes.size() == count) break;
    if (!text_.next_data()) {
      throw support::InputError(
          text_.files()[static_cast<std::size_t>(element.at.file)], {element.at.line, 1},
          fmt::format("the element has {} nodes; expected {}", element.nodes.size(), count));
    }
    first = 0;
  }
  // Abaqus orders the midpoint of a line between its ends.
  if (type.shape == MeshShape::line3) std::swap(element.nodes[1], element.nodes[2]);
  numbers.push_back(index_.add_element(text_.line(), std::move(element)));
}

// NODE OR SET, FIRST AXIS, LAST AXIS, VALUE; or NODE OR SET, NAME.
void AbaqusFile::boundary(const AbaqusCard& card) {
  allow_only(text_, card, {});
  while (text_.next_data()) {
    const auto fixed = fixed_here();
    for (const int node : groups_.nodes(text_.line(), 0)) {
      auto& support =
          supports_.try_emplace(node, MeshSupport{node, {}, text_.here()}).first->second;
      for (std::size_t axis = 0; axis < 3; ++axis) support.fixed[axis] |= fixed[axis];
    }
  }
}

std::array<bool, 3> AbaqusFile::fixed_here() const {
  const MeshText& line = text_.line();
  const std::string name = line.fields() > 1 ? capitals(line.field(1)) : std::string();
  if (name == "ENCASTRE" || name == "PINNED") return {true, true, true};
  if (name == "XSYMM") return {true, false, false};
  if (name == "YSYMM") return {false, true, false};
  if (name == "ZSYMM") return {false, false, true};
  const int first = line.whole(1, "an axis", 1);
  const bool has_last = line.fields() > 2 && !line.field(2).empty();
  const int last = has_last ? line.whole(2, "the last axis", 1) : first;
  if (first > 3 || last > 3 || last < first) {
    line.fail(1, fmt::format("axes {} to {}; expected axes from 1 to 3", first, last));
  }
  if (line.fields() > 3 && line.real(3, "a displacement") != 0) {
    line.fail(3, "a displacement that is not zero; expected 0, or nothing");
  }
  std::array<bool, 3> fixed{};
  for (int axis = first; axis <= last; ++axis) fixed[static_cast<std::size_t>(axis) - 1] = true;
  return fixed;
}

}  // namespace

MeshData read_abaqus(const MeshTexts& texts, const std::string& place) {
  return AbaqusFile(texts, place).read();
}

}  // namespace kusabi::problems
