// Keys of each kind of material.
#include "problems/files/draft/material_section.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "problems/files/draft/bar_group.hpp"
#include "problems/files/draft/body_properties.hpp"
#include "support/nearest.hpp"

namespace kusabi::problems {
namespace {

/// True if a material is one of bars: it has a key that bodies do not have.
bool is_of_bars(const TomlTable& table) {
  const auto has = [&](std::string_view key) { return table.table->contains(key); };
  return std::ranges::any_of(std::array{"EA", "A", "yield", "fy"}, has);
}

GroupMaterial bar_material(const TomlReader& reader, const TomlTable& table) {
  reader.allow_only(table, {"groups", "EA", "E", "A", "yield", "fy", "density", "expansion"});
  if (!table.table->contains("E")) {
    reader.require(table, "EA", "EA = an axial stiffness, a force, or E and A");
  }
  GroupMaterial material;
  material.of_bars = true;
  const auto bars = bars_in(reader, table);
  if (bars.residual) {
    reader.fail(*table.table->get("yield"),
                "residual stands in [[material]]; expected tension and compression only, or bars "
                "in [[members]]");
  }
  material.bar = bars.bar;
  material.position = bars.stiffness;
  return material;
}

std::string meant_instead(const std::string& name, const std::vector<std::string>& groups) {
  return support::did_you_mean(name, {groups.begin(), groups.end()});
}

[[noreturn]] void refuse_group(const ProblemDraft& draft, const TomlText& name,
                               const std::vector<std::string>& element_groups) {
  auto instead = meant_instead(name.text, element_groups);
  if (instead.empty()) {
    instead = element_groups.empty()
                  ? "; no mesh has any"
                  : fmt::format("; there are {}", names_of_groups(element_groups, ", "));
  }
  draft.reader().fail(
      name.position,
      fmt::format("no mesh has a group {} with elements; expected MESH.GROUP, the names of a mesh "
                  "from a file and of a group in it{}",
                  support::in_quotes(name.text), instead));
}

}  // namespace

GroupMaterial body_material(const ProblemDraft& draft, const TomlTable& table) {
  const TomlReader& reader = draft.reader();
  GroupMaterial material;
  Element& element = material.element;
  const auto& modulus = reader.require(table, "E", "E = Young's modulus, a force per area");
  material.position = reader.position(modulus);
  element.modulus = reader.number(modulus, "E");
  element.ratio = reader.number(reader.require(table, "nu", "nu = Poisson's ratio"), "nu");
  std::tie(element.density, element.expansion) = body_properties(reader, table);
  element.thickness = 1;
  const auto* plane = table.table->get("plane");
  if (draft.structure().dimension == 3) {
    const auto* thickness = table.table->get("thickness");
    if (plane == nullptr && thickness == nullptr) return material;
    reader.fail(plane != nullptr ? *plane : *thickness,
                "a thickness or a plane in space; expected E and nu only");
  }
  element.thickness =
      reader.number(reader.require(table, "thickness", "thickness = a length"), "thickness");
  if (plane == nullptr) return material;
  const TomlText state = reader.text(*plane, "plane");
  if (state.text != "stress" && state.text != "strain") {
    reader.fail(state.position, fmt::format("plane is {}; expected \"stress\" or \"strain\"",
                                            support::in_quotes(state.text)));
  }
  material.has_plane = true;
  element.state = state.text == "stress" ? PlaneState::stress : PlaneState::strain;
  return material;
}

std::vector<GroupMaterial> read_materials(const ProblemDraft& draft) {
  std::vector<GroupMaterial> materials;
  const toml::node* section = draft.section("material");
  if (section == nullptr) return materials;
  const TomlReader& reader = draft.reader();
  for (const TomlTable& table : reader.groups(*section, "material")) {
    const auto& groups = reader.require(table, "groups", "groups = [\"MESH.GROUP\", ...]");
    if (is_of_bars(table)) {
      materials.push_back(bar_material(reader, table));
    } else {
      reader.allow_only(table, {"groups", "E", "nu", "thickness", "plane", "density", "expansion",
                                "EA", "A", "yield", "fy"});
      materials.push_back(body_material(draft, table));
    }
    materials.back().groups = reader.texts(groups, "groups");
    materials.back().found.resize(materials.back().groups.size(), false);
  }
  return materials;
}

void require_all_found(const ProblemDraft& draft, const std::vector<GroupMaterial>& materials,
                       const std::vector<std::string>& element_groups) {
  for (const GroupMaterial& material : materials) {
    for (std::size_t i = 0; i < material.groups.size(); ++i) {
      if (!material.found[i]) refuse_group(draft, material.groups[i], element_groups);
    }
  }
}

void refuse_misspelt(const ProblemDraft& draft, const std::vector<GroupMaterial>& materials,
                     const std::vector<std::string>& element_groups, const std::string& mesh) {
  for (const GroupMaterial& material : materials) {
    for (std::size_t i = 0; i < material.groups.size(); ++i) {
      const auto& name = material.groups[i];
      const bool is_meant =
          name.text.starts_with(mesh + ".") || !meant_instead(name.text, element_groups).empty();
      if (!material.found[i] && is_meant) refuse_group(draft, name, element_groups);
    }
  }
}

}  // namespace kusabi::problems
