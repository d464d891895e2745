// Groups of an Abaqus file by name: *NSET, *ELSET and *SURFACE.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

#include "problems/files/meshes/abaqus_text.hpp"
#include "problems/files/meshes/mesh_data.hpp"
#include "problems/files/meshes/mesh_index.hpp"

namespace kusabi::problems {

class AbaqusGroups {
 public:
  AbaqusGroups(MeshData& mesh, const MeshIndex& index) : mesh_(mesh), index_(index) {}

  /// The group with a name; it is created if there is none.
  MeshGroup& group(const AbaqusText& text, const std::string& name, MeshPlace at);

  /// The nodes of a set, or a single node, named by a field of the line.
  std::vector<int> nodes(const MeshText& line, std::size_t field) const;
  /// The elements of a set, or a single element, named by a field of the line.
  std::vector<int> elements(const MeshText& line, std::size_t field) const;
  /// The elements of the set that a parameter names.
  const std::vector<int>& element_set(const AbaqusText& text, const std::string& name) const;

  void read_node_set(AbaqusText& text, const AbaqusCard& card);
  void read_element_set(AbaqusText& text, const AbaqusCard& card);
  void read_surface(AbaqusText& text, const AbaqusCard& card);

 private:
  const MeshGroup* find(std::string_view name) const;
  /// The members of the set that a field names. @param kind "node" or "element"
  const std::vector<int>& set_named(const MeshText& line, std::size_t field, std::string_view kind,
                                    std::vector<int> MeshGroup::*members) const;
  void read_face(const AbaqusText& text, MeshGroup& group);

  MeshData& mesh_;
  const MeshIndex& index_;
  std::map<std::string, std::size_t, std::less<>> numbers_;  // by name in capitals
};

/// @throws InputError at a parameter that is not `allowed`
void allow_only(const AbaqusText& text, const AbaqusCard& card,
                std::initializer_list<std::string_view> allowed);

/// The value of a required parameter.
const std::string& required(const AbaqusText& text, const AbaqusCard& card, std::string_view name);

}  // namespace kusabi::problems
