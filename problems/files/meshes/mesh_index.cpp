// Map of tags to indices.
#include "problems/files/meshes/mesh_index.hpp"

#include <algorithm>
#include <numeric>
#include <ranges>
#include <utility>

#include <fmt/format.h>

#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

/// Sorts `all` by instance and tag. @return the new index of each
template <class Entry>
std::vector<int> sort_entries(std::vector<Entry>& all) {
  std::vector<int> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int number) {
    const Entry& entry = all[static_cast<std::size_t>(number)];
    return std::pair(entry.instance, entry.tag);
  });
  std::vector<int> place(all.size());
  std::vector<Entry> sorted;
  sorted.reserve(all.size());
  for (const int entry : order) {
    place[static_cast<std::size_t>(entry)] = static_cast<int>(sorted.size());
    sorted.push_back(std::move(all[static_cast<std::size_t>(entry)]));
  }
  all = std::move(sorted);
  return place;
}

void renumber(std::vector<int>& numbers, const std::vector<int>& place) {
  for (int& number : numbers) number = place[static_cast<std::size_t>(number)];
}

}  // namespace

std::uint64_t MeshIndex::key(int tag, int instance) {
  constexpr unsigned bits = 32;
  return (static_cast<std::uint64_t>(instance) << bits) | static_cast<std::uint64_t>(tag);
}

int MeshIndex::found(const Numbers& numbers, int tag, int instance) {
  const auto entry = numbers.find(key(tag, instance));
  return entry == numbers.end() ? unknown : entry->second;
}

void MeshIndex::leave_out_element(int tag) {
  elements_.emplace(key(tag, instance_), left_out);
  elements_left_out_.push_back(tag);
}

void MeshIndex::add_node(const MeshText& text, MeshNode node) {
  node.instance = instance_;
  const auto [entry, is_new] =
      nodes_.emplace(key(node.tag, instance_), static_cast<int>(mesh_.nodes.size()));
  if (!is_new) {
    const MeshPlace& first = mesh_.nodes[static_cast<std::size_t>(entry->second)].at;
    text.fail(0, fmt::format("node {} is given twice, first on line {}; expected once", node.tag,
                             first.line));
  }
  mesh_.nodes.push_back(node);
}

int MeshIndex::add_element(const MeshText& text, MeshElement element) {
  const auto number = static_cast<int>(mesh_.elements.size());
  element.instance = instance_;
  const auto [entry, is_new] = elements_.emplace(key(element.tag, instance_), number);
  if (!is_new && entry->second == left_out) {
    text.fail(0, fmt::format("element {} is given twice; expected once", element.tag));
  }
  if (!is_new) {
    const MeshPlace& first = mesh_.elements[static_cast<std::size_t>(entry->second)].at;
    text.fail(0, fmt::format("element {} is given twice, first on line {}; expected once",
                             element.tag, first.line));
  }
  auto nodes = element.nodes;
  std::ranges::sort(nodes);
  const auto twice = std::ranges::adjacent_find(nodes);
  if (twice != nodes.end()) {
    const MeshNode& node = mesh_.nodes[static_cast<std::size_t>(*twice)];
    text.fail(fmt::format("element {} has node {} twice; expected different nodes", element.tag,
                          node.tag));
  }
  mesh_.elements.push_back(std::move(element));
  return number;
}

int MeshIndex::node(const MeshText& text, std::size_t field) const {
  const int tag = text.whole(field, "the number of a node", 1);
  const int number = find_node(tag);
  if (number < 0) {
    text.fail(field, fmt::format("node {} does not exist; expected one that is given above", tag));
  }
  return number;
}

int MeshIndex::element(const MeshText& text, std::size_t field) const {
  const int tag = text.whole(field, "the number of an element", 1);
  const int number = find_element(tag);
  if (number == unknown) {
    text.fail(field,
              fmt::format("element {} does not exist; expected one that is given above", tag));
  }
  return number;
}

void sort_by_tag(MeshData& mesh) {
  const auto node_place = sort_entries(mesh.nodes);
  const auto element_place = sort_entries(mesh.elements);
  for (MeshElement& element : mesh.elements) renumber(element.nodes, node_place);
  for (MeshGroup& group : mesh.groups) {
    renumber(group.nodes, node_place);
    renumber(group.elements, element_place);
    for (MeshFace& face : group.faces) {
      face.element = element_place[static_cast<std::size_t>(face.element)];
    }
  }
  for (MeshSection& section : mesh.sections) renumber(section.elements, element_place);
  for (MeshSupport& support : mesh.supports) {
    support.node = node_place[static_cast<std::size_t>(support.node)];
  }
  for (MeshLoad& load : mesh.loads) load.node = node_place[static_cast<std::size_t>(load.node)];
}

}  // namespace kusabi::problems
