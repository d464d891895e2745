// Nodes and elements of a mesh during reading, found by their tags, which are unique within an
// instance.
#pragma once

#include <cstdint>
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

  /// Sets the instance of the following tags.
  void enter(int instance) { instance_ = instance; }
  int instance() const { return instance_; }

  /// @throws InputError at field 0 of the line if the tag exists
  void add_node(const MeshText& text, MeshNode node);
  /// @throws InputError if the tag exists, or if the element has a node twice
  int add_element(const MeshText& text, MeshElement element);

  /// Records an element that is left out of the mesh, and of sets that contain it.
  void leave_out_element(int tag);

  /// Tags of these elements, in the order of the file.
  const std::vector<int>& elements_left_out() const { return elements_left_out_; }

  /// The index of the node, or element, whose tag is in a field of the line; `left_out` for
  /// elements that are left out.
  int node(const MeshText& text, std::size_t field) const;
  int element(const MeshText& text, std::size_t field) const;

  /// The index of a node; `unknown` if there is none.
  int find_node(int tag, int instance) const { return found(nodes_, tag, instance); }
  int find_node(int tag) const { return find_node(tag, instance_); }
  int find_element(int tag, int instance) const { return found(elements_, tag, instance); }
  int find_element(int tag) const { return find_element(tag, instance_); }

  static constexpr int unknown = -1;
  static constexpr int left_out = -2;

 private:
  using Numbers = std::unordered_map<std::uint64_t, int>;

  static std::uint64_t key(int tag, int instance);
  static int found(const Numbers& numbers, int tag, int instance);

  MeshData& mesh_;
  Numbers nodes_;
  Numbers elements_;
  std::vector<int> elements_left_out_;
  int instance_ = 0;
};

/// Sorts nodes and elements by instance and tag and adjusts all indices.
void sort_by_tag(MeshData& mesh);

}  // namespace kusabi::problems
