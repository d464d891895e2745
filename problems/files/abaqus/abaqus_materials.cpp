// Materials by name.
#include "problems/files/abaqus/abaqus_materials.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "support/input_error.hpp"

namespace kusabi::problems {

void AbaqusMaterials::read_material(AbaqusText& text, const AbaqusCard& card) {
  const auto& name = required(text, card, "NAME");
  const auto [entry, is_new] = materials_.emplace(capitals(name), Material{});
  if (!is_new) {
    text.line().fail(
        fmt::format("material {} is given twice; expected once", support::in_quotes(name)));
  }
  latest_ = &entry->second;
  if (text.next_data()) text.line().fail("a data line of *MATERIAL; expected none");
}

// A material that is not isotropic, or changes with temperature, has no constants: elements of it
// need those of a [[material]].
void AbaqusMaterials::read_elastic(AbaqusText& text, const AbaqusCard& card) {
  allow_only(text, card, {"TYPE", "MODULI"});
  if (latest_ == nullptr)
    text.line().fail(
        "*ELASTIC without a material; expected *MATERIAL "
        "before it");
  if (latest_->read) text.line().fail("a second *ELASTIC of one material; expected one");
  latest_->read = true;
  if (const auto* type = card.find("TYPE"); type != nullptr) {
    const std::string kind = capitals(*type);
    if (kind != "ISO" && kind != "ISOTROPIC") {
      latest_->fault = fmt::format("has *ELASTIC of type {}, not ISO", kind);
      while (text.next_data()) continue;
      return;
    }
  }
  if (!text.next_data()) text.line().fail("*ELASTIC without numbers; expected E, nu");
  latest_->modulus = text.line().real(0, "Young's modulus");
  latest_->ratio = text.line().real(1, "Poisson's ratio");
  latest_->fault.clear();
  while (text.next_data()) latest_->fault = "changes with temperature";
}

void AbaqusMaterials::read_density(AbaqusText& text) {
  if (latest_ == nullptr)
    text.line().fail("*DENSITY without a material; expected *MATERIAL before it");
  if (!text.next_data()) text.line().fail("*DENSITY without a number; expected the density");
  latest_->density = text.line().real(0, "a density");
  while (text.next_data()) continue;  // at other temperatures
}

void AbaqusMaterials::read_section(AbaqusText& text, const AbaqusCard& card,
                                   AbaqusModel& part) const {
  allow_only(text, card, {"ELSET", "MATERIAL", "ORIENTATION", "CONTROLS", "OFFSET"});
  const MeshGroup& set = part.groups.element_set(text, required(text, card, "ELSET"));
  MeshSection section{
      set.elements, 0, 0, 1, card.at, set.name, required(text, card, "MATERIAL"), {}};
  if (text.next_data()) {
    if (text.line().fields() > 0 && !text.line().field(0).empty()) {
      section.measure = text.line().real(0, "a thickness or an area");
    }
    if (text.next_data()) text.line().fail("a second line of *SOLID SECTION; expected one");
  }
  part.mesh.sections.push_back(std::move(section));
}

void AbaqusMaterials::finish(MeshData& mesh) const {
  std::vector<bool> has_section(mesh.elements.size(), false);
  for (MeshSection& section : mesh.sections) {
    const auto fail = [&](const std::string& message) {
      throw support::InputError(mesh.files[static_cast<std::size_t>(section.at.file)],
                                {section.at.line, 1}, message);
    };
    for (const int element : section.elements) {
      if (has_section[static_cast<std::size_t>(element)]) {
        fail(fmt::format("element {} has two sections; expected one",
                         mesh_name(mesh, mesh.elements[static_cast<std::size_t>(element)])));
      }
      has_section[static_cast<std::size_t>(element)] = true;
    }
    const auto material = materials_.find(capitals(section.material));
    if (material == materials_.end()) {
      fail(
          fmt::format("material {} of the section does not exist; expected *MATERIAL with *ELASTIC",
                      support::in_quotes(section.material)));
    }
    section.modulus = material->second.modulus;
    section.ratio = material->second.ratio;
    section.density = material->second.density;
    if (material->second.fault.empty()) continue;
    section.fault =
        fmt::format("material {} {}", support::in_quotes(section.material), material->second.fault);
  }
}

}  // namespace kusabi::problems
