// Nodes and elements of a mesh while it is read: found by their tags, each tag once.
#pragma once

#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "problems/files/meshes/mesh_data.hpp"
#include "problems/files/meshes/mesh_text.hpp"

namespace kusabi::problems {

class MeshIndex {
 public:
  explicit MeshIndex(MeshData& mesh) : mesh_(mesh) {}

  /// @throws InputError at field 0 of the line if there is one of this tag
  void add_node(const MeshText& text, MeshNode node);
  /// The same of elements; and if the element has a node twice.
  int add_element(const MeshText& text, MeshElement element);

  /// The number of the node, or element, that a field of the line tells by its tag.
  int node(const MeshText& text, std::size_t field) const;
  int element(const MeshText& text, std::size_t field) const;

  /// -1: there is none.
  int find_node(int tag) const;
  int find_element(int tag) const;

 private:
  MeshData& mesh_;
  std::unordered_map<int, int> nodes_;
  std::unordered_map<int, int> elements_;
};

/// Brings nodes and elements in the order of their tags; all numbers follow.
void sort_by_tag(MeshData& mesh);

}  // namespace kusabi::problems
