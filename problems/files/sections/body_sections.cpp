// Bars and elements: [[members]] and [[elements]].
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/draft/bar_group.hpp"
#include "problems/files/draft/body_properties.hpp"
#include "problems/files/sections/problem_sections.hpp"
#include "problems/structure/model/element_shape.hpp"

namespace kusabi::problems {
namespace {

void member_group(ProblemDraft& draft, const TomlTable& group) {
  const TomlReader& reader = draft.reader();
  Structure& structure = draft.structure();
  reader.allow_only(group,
                    {"EA", "E", "A", "yield", "fy", "buckling", "density", "expansion", "between"});
  const BarGroup bars = bars_in(reader, group);
  const auto& between = reader.require(group, "between", "between = [[\"a\", \"b\"], ...]");
  for (const toml::node* pair : reader.elements(between, "between")) {
    const auto ends = reader.texts(*pair, "a member");
    if (ends.size() != 2) {
      reader.fail(*pair, fmt::format("a member has {} ends; expected two node names, [\"a\", "
                                     "\"b\"]",
                                     ends.size()));
    }
    Member bar = bars.bar;
    bar.first = draft.node(ends[0]);
    bar.second = draft.node(ends[1]);
    bar.yield = bars.yield_at(
        (structure.coordinates.col(bar.second) - structure.coordinates.col(bar.first)).norm());
    structure.members.push_back(bar);
    structure.sources.members.push_back(reader.position(*pair));
    structure.sources.axial_stiffnesses.push_back(bars.stiffness);
    structure.sources.yields.push_back(bars.yield);
  }
}

void refuse_plane_keys(const TomlReader& reader, const TomlTable& group) {
  for (const char* key : {"thickness", "plane"}) {
    const toml::node* entry = group.table->get(key);
    if (entry == nullptr) continue;
    reader.fail(*entry, fmt::format("{} is for elements in the plane; expected E and nu only, for "
                                    "dimension = 3",
                                    key));
  }
}

void element_group(ProblemDraft& draft, const TomlTable& group) {
  const TomlReader& reader = draft.reader();
  reader.allow_only(group, {"E", "nu", "thickness", "plane", "density", "expansion", "between"});
  Element element = material(reader, group, draft.structure().dimension);
  const auto& between =
      reader.require(group, "between", "between = [[\"a\", \"b\", \"c\", \"d\"], ...]");
  for (const toml::node* entry : reader.elements(between, "between")) {
    const auto names = reader.texts(*entry, "an element");
    const int dimension = draft.structure().dimension;
    const auto shape = shape_of(dimension, names.size());
    if (!shape) {
      reader.fail(*entry, fmt::format("an element has {} nodes; expected {}", names.size(),
                                      dimension == 2 ? "3, 4, 6 or 8 names in the plane"
                                                     : "4, 5, 6, 8, 10, 15 or 20 names in space"));
    }
    element.shape = *shape;
    std::vector<int> nodes;
    nodes.reserve(names.size());
    for (const TomlText& name : names) nodes.push_back(draft.node(name));
    add_element(draft, element, nodes, reader.position(*entry),
                reader.position(*group.table->get("E")));
  }
}

}  // namespace

void read_members(ProblemDraft& draft) {
  const bool has_others = draft.section("elements") != nullptr ||
                          draft.section("mesh") != nullptr || draft.section("stiffness") != nullptr;
  if (draft.section("members") == nullptr && has_others) return;
  const TomlReader& reader = draft.reader();
  const auto& section = reader.require(reader.root(), "members", "at least one [[members]] group");
  for (const TomlTable& group : reader.groups(section, "members")) member_group(draft, group);
}

void read_elements(ProblemDraft& draft) {
  const toml::node* section = draft.section("elements");
  if (section == nullptr) return;
  for (const TomlTable& group : draft.reader().groups(*section, "elements")) {
    element_group(draft, group);
  }
}

Element material(const TomlReader& reader, const TomlTable& group, int dimension) {
  Element element{};
  element.modulus =
      reader.number(reader.require(group, "E", "E = Young's modulus, a force per area"), "E");
  element.ratio = reader.number(reader.require(group, "nu", "nu = Poisson's ratio"), "nu");
  std::tie(element.density, element.expansion) = body_properties(reader, group);
  if (dimension == 3) {
    refuse_plane_keys(reader, group);
    return element;
  }
  element.thickness =
      reader.number(reader.require(group, "thickness", "thickness = a length"), "thickness");
  const auto& plane = reader.require(group, "plane", "plane = \"stress\" or \"strain\"");
  const TomlText state = reader.text(plane, "plane");
  if (state.text != "stress" && state.text != "strain") {
    reader.fail(state.position, fmt::format("plane is {}; expected \"stress\" or \"strain\"",
                                            support::in_quotes(state.text)));
  }
  element.state = state.text == "stress" ? PlaneState::stress : PlaneState::strain;
  return element;
}

void add_element(ProblemDraft& draft, Element element, std::vector<int> nodes,
                 support::SourcePosition position, support::SourcePosition material_position) {
  Structure& structure = draft.structure();
  element.nodes = std::move(nodes);
  structure.elements.push_back(std::move(element));
  structure.sources.elements.push_back(position);
  structure.sources.materials.push_back(material_position);
}

}  // namespace kusabi::problems
