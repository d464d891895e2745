// Materials of [[material]] have precedence over the sections of the mesh file.
#include "problems/files/draft/mesh_body.hpp"

#include <cstddef>

#include <fmt/format.h>

#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

/// Assigns a material to the elements of a group.
void give(const ProblemDraft& draft, const MeshData& mesh, const MeshGroup& group,
          const GroupMaterial& material, const TomlText& name, std::vector<MeshUse>& uses) {
  const int dimension = material.of_bars ? 1 : draft.structure().dimension;
  bool given = false;
  for (const int number : group.elements) {
    const MeshElement& element = mesh.elements[static_cast<std::size_t>(number)];
    if (mesh_dimension(element.shape) != dimension) continue;
    given = true;
    auto& place = uses[static_cast<std::size_t>(number)].material;
    if (place != nullptr) {
      draft.reader().fail(name.position,
                          fmt::format("element {} of group {} has a material already; expected one",
                                      mesh_name(mesh, element), support::in_quotes(name.text)));
    }
    place = &material;
  }
  if (given) return;
  draft.reader().fail(
      name.position,
      fmt::format("group {} has no {}; expected a group that has some",
                  support::in_quotes(name.text),
                  material.of_bars ? "lines" : "elements of the dimension of the problem"));
}

/// Marks elements of the body and bars. @return true if there are any
bool give_roles(const MeshData& mesh, int dimension, std::vector<MeshUse>& uses) {
  bool any = false;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const MeshElement& element = mesh.elements[i];
    const int own = mesh_dimension(element.shape);
    if (own > dimension) {
      fail_in_mesh(mesh, element.at,
                   fmt::format("element {} is {}; expected elements in the plane, or dimension = 3",
                               mesh_name(mesh, element), mesh_called(element.shape)));
    }
    if (own == dimension) uses[i].role = MeshUse::Role::body;
    const bool is_made = uses[i].material != nullptr ||
                         (uses[i].section != nullptr && uses[i].section->fault.empty());
    if (own == 1 && is_made) {
      uses[i].role = MeshUse::Role::bar;
      if (element.shape != MeshShape::line2) {
        fail_in_mesh(mesh, element.at,
                     fmt::format("element {} is {}; expected bars of two nodes",
                                 mesh_name(mesh, element), mesh_called(element.shape)));
      }
    }
    any = any || uses[i].role != MeshUse::Role::name;
  }
  return any;
}

}  // namespace

void fail_in_mesh(const MeshData& mesh, MeshPlace at, const std::string& message) {
  throw support::InputError(mesh.files[static_cast<std::size_t>(at.file)], {at.line, 1}, message);
}

std::vector<MeshUse> mesh_uses(const ProblemDraft& draft, const MeshData& mesh,
                               const std::string& name, std::vector<GroupMaterial>& materials) {
  std::vector<MeshUse> uses(mesh.elements.size());
  for (const MeshSection& section : mesh.sections) {
    for (const int element : section.elements) {
      uses[static_cast<std::size_t>(element)].section = &section;
    }
  }
  for (GroupMaterial& material : materials) {
    for (std::size_t i = 0; i < material.groups.size(); ++i) {
      for (const MeshGroup& group : mesh.groups) {
        if (material.groups[i].text != name + "." + group.name) continue;
        give(draft, mesh, group, material, material.groups[i], uses);
        material.found[i] = true;
      }
    }
  }
  const int dimension = draft.structure().dimension;
  if (!give_roles(mesh, dimension, uses)) {
    const bool by_gmsh = mesh.files.front().ends_with(".msh");
    fail_in_mesh(
        mesh, {0, 1},
        fmt::format("the mesh has no elements of dimension {} and no bars; expected some{}",
                    dimension,
                    !by_gmsh         ? ""
                    : dimension == 2 ? ": Gmsh saves those of a Physical Surface, or all with "
                                       "Mesh.SaveAll = 1"
                                     : ": Gmsh saves those of a Physical Volume, or all with "
                                       "Mesh.SaveAll = 1"));
  }
  return uses;
}

}  // namespace kusabi::problems
