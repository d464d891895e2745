// Conversion of elements to outlines, and supports of unused nodes.
#include "problems/files/draft/stiffness_outlines.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "problems/structure/model/superelement.hpp"

namespace kusabi::problems {
namespace {

// Moves the elements of meshes with given stiffness, which have no stiffness of their own, to the
// outlines.
void move_elements(const std::set<const NamedMesh*>& meshes, Structure& structure) {
  std::vector<bool> is_outline(structure.elements.size(), false);
  for (const NamedMesh* mesh : meshes) {
    const auto first = is_outline.begin() + static_cast<std::ptrdiff_t>(mesh->first_element);
    std::fill_n(first, mesh->elements, true);
  }
  auto& sources = structure.sources;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < is_outline.size(); ++i) {
    if (is_outline[i]) {
      structure.outlines.push_back(std::move(structure.elements[i]));
      continue;
    }
    if (kept != i) structure.elements[kept] = std::move(structure.elements[i]);
    sources.elements[kept] = sources.elements[i];
    sources.materials[kept] = sources.materials[i];
    ++kept;
  }
  structure.elements.resize(kept);
  sources.elements.resize(kept);
  sources.materials.resize(kept);
}

// Supports nodes of outlines that occur in no matrix: they were fixed or eliminated when the matrix
// was computed.
void hold_others(const std::set<const NamedMesh*>& meshes, Structure& structure) {
  std::vector<bool> hangs(structure.node_names.size(), false);
  const auto mark = [&](int node) { hangs[static_cast<std::size_t>(node)] = true; };
  for (const Superelement& each : structure.superelements)
    std::ranges::for_each(nodes_of(each), mark);
  for (const Element& element : structure.elements) std::ranges::for_each(element.nodes, mark);
  for (const Member& bar : structure.members) {
    mark(bar.first);
    mark(bar.second);
  }
  for (const NamedMesh* mesh : meshes) {
    for (const int node : mesh->nodes) {
      const auto place = static_cast<std::size_t>(node);
      if (!hangs[place]) structure.fixed[place] = {true, true, structure.dimension == 3};
    }
  }
}

}  // namespace

void set_outlines(const std::set<const NamedMesh*>& meshes, Structure& structure) {
  move_elements(meshes, structure);
  hold_others(meshes, structure);
}

}  // namespace kusabi::problems
