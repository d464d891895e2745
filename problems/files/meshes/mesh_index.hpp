// Nodes and elements of a mesh during reading, found by their tags, which are unique.
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

  /// @throws InputError at field 0 of the line if the tag exists
  void add_node(const MeshText& text, MeshNode node);
  /// @throws InputError if the tag exists, or if the element has a node twice
  int add_element(const MeshText& text, MeshElement element);

  /// The index of the node, or element, whose tag is in a field of the line.
  int node(const MeshText& text, std::size_t field) const;
  int element(const MeshText& text, std::size_t field) const;

  /// The index of a node; -1 if there is none.
  int find_node(int tag) const;
  int find_element(int tag) const;

 private:
  MeshData& mesh_;
  std::unordered_map<int, int> nodes_;
  std::unordered_map<int, int> elements_;
};

/// Sorts nodes and elements by their tags and adjusts all indices.
void sort_by_tag(MeshData& mesh);

}  // namespace kusabi::problems
