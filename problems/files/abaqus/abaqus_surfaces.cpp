// Surfaces: faces of elements, elements that are surfaces, or nodes.
#include <algorithm>
#include <cstddef>
#include <set>

#include <fmt/format.h>

#include "problems/files/abaqus/abaqus_groups.hpp"
#include "problems/files/meshes/mesh_groups.hpp"
#include "problems/structure/geometry/element_faces.hpp"
#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

/// Maximum number of faces of an element.
constexpr std::size_t max_faces = 6;

/// Removes repetitions and keeps the first occurrence.
void keep_first(std::vector<int>& nodes) {
  std::set<int> seen;
  std::erase_if(nodes, [&](int node) { return !seen.insert(node).second; });
}

}  // namespace

void AbaqusGroups::read_surface(AbaqusText& text, const AbaqusCard& card) {
  const std::string* type = card.find("TYPE");
  const std::string kind = type == nullptr ? "ELEMENT" : capitals(*type);
  if (kind != "ELEMENT" && kind != "NODE") {
    text.warn(fmt::format("*SURFACE of type {} is left out", kind), card.at);
    add_analytical(required(text, card, "NAME"));
    while (text.next_data()) continue;
    return;
  }
  allow_only(text, card, {"NAME", "TYPE", "INTERNAL"});
  const std::string& name = required(text, card, "NAME");
  MeshGroup& surface = surfaces_[capitals(full_name(name))];
  const MeshGroup before = surface;
  while (text.next_data()) {
    if (kind == "ELEMENT") {
      read_face(text.line(), surface);
    } else {
      const auto more = nodes(text.line(), 0);
      surface.nodes.insert(surface.nodes.end(), more.begin(), more.end());
      if (surface.nodes.size() > 2 * mesh_.nodes.size()) {
        keep_first(surface.nodes);
      }
    }
  }
  keep_first(surface.nodes);
  MeshGroup& all = group(text, name, card.at);
  all.faces = surface.faces;
  for (const auto members : {&MeshGroup::nodes, &MeshGroup::elements}) {
    if (all.*members == before.*members) all.*members = surface.*members;
    refuse_other_members(text, name, all, members);
  }
}

// Sets and surfaces have name spaces of their own, but a group has one name.
void AbaqusGroups::refuse_other_members(const AbaqusText& text, const std::string& name,
                                        const MeshGroup& all,
                                        std::vector<int> MeshGroup::*members) const {
  const auto found = surfaces_.find(capitals(full_name(name)));
  if (found == surfaces_.end() || (found->second.*members).empty()) return;
  const auto sorted = [&](const MeshGroup& group) {
    return std::set<int>((group.*members).begin(), (group.*members).end());
  };
  if (sorted(all) == sorted(found->second)) return;
  text.line().fail(
      fmt::format("surface {} has the name of a set with other {}; expected another name",
                  support::in_quotes(name), members == &MeshGroup::nodes ? "nodes" : "elements"));
}

// A surface of elements that are surfaces themselves consists of these, one without a face of the
// free faces.
void AbaqusGroups::read_face(const MeshText& line, MeshGroup& surface) {
  const auto set = elements(line, 0);
  const std::string label = line.fields() > 1 ? capitals(line.field(1)) : std::string();
  if (label.empty()) {
    const auto faces = free_faces(mesh_, set);
    surface.faces.insert(surface.faces.end(), faces.begin(), faces.end());
  }
  const int face = label.size() == 2 && label[0] == 'S' ? label[1] - '1' : -1;
  for (const int number : set) {
    const MeshElement& element = mesh_.elements[static_cast<std::size_t>(number)];
    const int dimension = mesh_dimension(element.shape);
    if (label == "SPOS" || label == "SNEG" || (label.empty() && dimension < 2)) {
      surface.elements.push_back(number);
    } else if (!label.empty()) {
      const int faces =
          dimension < 2 ? 0 : static_cast<int>(element_faces(element_shape(element.shape)).size());
      if (face < 0 || face >= faces) {
        line.fail(1, fmt::format("face {} of element {}, {}; expected one of S1 to S{}",
                                 support::in_quotes(label), element.tag, mesh_called(element.shape),
                                 faces));
      }
      surface.faces.push_back({number, face});
    }
  }
  if (surface.faces.size() + surface.elements.size() > max_faces * mesh_.elements.size()) {
    line.fail("a surface with more faces than the mesh; expected each face once");
  }
}

}  // namespace kusabi::problems
