// The dimension is that of the elements with the highest one.
#include "problems/files/decks/deck_draft.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "problems/files/meshes/mesh_groups.hpp"
#include "problems/files/toml/toml_text.hpp"

namespace kusabi::problems {

DeckDraft::DeckDraft(const MeshData& mesh, std::string prefix)
    : mesh_(mesh), prefix_(std::move(prefix)), used_(mesh.nodes.size(), false) {
  std::vector<bool> is_bar(mesh.elements.size(), false);
  for (const MeshSection& section : mesh.sections)
    for (const int element : section.elements) is_bar[static_cast<std::size_t>(element)] = true;
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const MeshElement& element = mesh.elements[i];
    const bool bar_in_space = is_bar[i] && std::ranges::any_of(element.nodes, [&](int node) {
                                return mesh.nodes[static_cast<std::size_t>(node)].place.z() != 0;
                              });
    if (mesh_dimension(element.shape) == 3 || bar_in_space) dimension_ = 3;
  }
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const MeshElement& element = mesh.elements[i];
    const bool bar = is_bar[i] && mesh_dimension(element.shape) == 1;
    if (!bar && !is_body(element)) continue;
    for (const int node : element.nodes) used_[static_cast<std::size_t>(node)] = true;
  }
  places_.resize(dimension_, static_cast<Eigen::Index>(mesh.nodes.size()));
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    places_.col(static_cast<Eigen::Index>(i)) = mesh.nodes[i].place.head(dimension_);
}

const MeshGroup* DeckDraft::group(const std::string& name) const {
  const auto found = std::ranges::find(mesh_.groups, name, &MeshGroup::name);
  return found == mesh_.groups.end() ? nullptr : &*found;
}

ChosenNodes DeckDraft::nodes_of(const MeshGroup& group) const {
  ChosenNodes result{group.name, group_nodes(mesh_, group), {}};
  std::erase_if(result.all, [&](int node) { return !is_used(node); });
  result.chosen = result.all;
  return result;
}

ChosenNodes DeckDraft::nodes_of_surface(const MeshGroup& group) const {
  if (group.faces.empty() || group.nodes.empty()) return nodes_of(group);
  MeshGroup surface = group;
  surface.nodes.clear();
  auto result = nodes_of(surface);
  const std::set<int> listed(group.nodes.begin(), group.nodes.end());
  if (listed != std::set<int>(result.all.begin(), result.all.end())) result.group.clear();
  return result;
}

std::string DeckDraft::name(int node) const {
  return prefix_ + "." + mesh_name(mesh_, mesh_.nodes[static_cast<std::size_t>(node)]);
}

std::string DeckDraft::lines(const ChosenNodes& nodes) const {
  const auto names = [&](const std::vector<int>& list) {
    std::vector<std::string> result;
    result.reserve(list.size());
    for (const int node : list) result.push_back(name(node));
    return toml_texts(result);
  };
  if (nodes.group.empty() || 2 * nodes.chosen.size() < nodes.all.size())
    return fmt::format("nodes = {}\n", names(nodes.chosen));
  std::string text = fmt::format("nodes = {}\n", toml_texts({name(nodes.group)}));
  const std::set<int> chosen(nodes.chosen.begin(), nodes.chosen.end());
  std::vector<int> others;
  for (const int node : nodes.all)
    if (!chosen.contains(node)) others.push_back(node);
  if (!others.empty()) text += fmt::format("except = {}\n", names(others));
  return text;
}

std::string DeckDraft::line(MeshPlace at) const {
  const std::filesystem::path file(mesh_.files[static_cast<std::size_t>(at.file)]);
  return fmt::format("line {} of {}", at.line, file.filename().string());
}

void DeckDraft::warn(MeshPlace at, const std::string& message) {
  warnings_.push_back(
      fmt::format("{}:{}: {}", mesh_.files[static_cast<std::size_t>(at.file)], at.line, message));
}

}  // namespace kusabi::problems
