// Materials by name.
#include "problems/files/meshes/abaqus_materials.hpp"

#include <cstddef>

#include <fmt/format.h>

#include "support/input_error.hpp"

namespace kusabi::problems {

void AbaqusMaterials::read_material(AbaqusText& text, const AbaqusCard& card) {
  allow_only(text, card, {"NAME"});
  const auto& name = required(text, card, "NAME");
  const auto [entry, is_new] = materials_.emplace(capitals(name), Material{});
  if (!is_new) {
    text.line().fail(
        fmt::format("material {} is given twice; expected once", support::in_quotes(name)));
  }
  latest_ = &entry->second;
  if (text.next_data()) text.line().fail("a data line of *MATERIAL; expected none");
}

void AbaqusMaterials::read_elastic(AbaqusText& text, const AbaqusCard& card) {
  allow_only(text, card, {"TYPE"});
  if (latest_ == nullptr) text.line().fail("*ELASTIC of no material; expected *MATERIAL before");
  if (latest_->elastic) text.line().fail("a second *ELASTIC of one material; expected one");
  if (const auto* type = card.find("TYPE"); type != nullptr) {
    const std::string kind = capitals(*type);
    if (kind != "ISO" && kind != "ISOTROPIC") {
      text.line().fail(fmt::format("*ELASTIC of type {}; expected ISO", support::in_quotes(kind)));
    }
  }
  if (!text.next_data()) text.line().fail("*ELASTIC without numbers; expected E, nu");
  latest_->modulus = text.line().real(0, "Young's modulus");
  latest_->ratio = text.line().real(1, "Poisson's ratio");
  latest_->elastic = true;
  if (text.next_data()) {
    text.line().fail("a material that changes with temperature; expected one line E, nu");
  }
}

// A second section would give an element two materials.
void AbaqusMaterials::read_section(AbaqusText& text, const AbaqusCard& card) {
  allow_only(text, card, {"ELSET", "MATERIAL"});
  const auto& set = groups_.element_set(text, required(text, card, "ELSET"));
  names_.push_back(capitals(required(text, card, "MATERIAL")));
  has_section_.resize(mesh_.elements.size(), false);
  for (const int element : set) {
    if (has_section_[static_cast<std::size_t>(element)]) {
      text.line().fail(fmt::format("element {} has two sections; expected one",
                                   mesh_.elements[static_cast<std::size_t>(element)].tag));
    }
    has_section_[static_cast<std::size_t>(element)] = true;
  }
  mesh_.sections.push_back({set, 0, 0, 1, card.at});
  if (!text.next_data()) return;
  if (text.line().fields() > 0 && !text.line().field(0).empty()) {
    mesh_.sections.back().measure = text.line().real(0, "a thickness or an area");
  }
  if (text.next_data()) text.line().fail("a second line of *SOLID SECTION; expected one");
}

void AbaqusMaterials::finish() {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    MeshSection& section = mesh_.sections[i];
    const auto material = materials_.find(names_[i]);
    if (material == materials_.end() || !material->second.elastic) {
      throw support::InputError(
          mesh_.files[static_cast<std::size_t>(section.at.file)], {section.at.line, 1},
          fmt::format("material {} of the section {}; expected *MATERIAL with *ELASTIC",
                      support::in_quotes(names_[i]),
                      material == materials_.end() ? "does not exist" : "has no elasticity"));
    }
    section.modulus = material->second.modulus;
    section.ratio = material->second.ratio;
  }
}

}  // namespace kusabi::problems
