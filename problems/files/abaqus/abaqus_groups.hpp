// Groups of an Abaqus file by name: *NSET, *ELSET and *SURFACE.
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/files/abaqus/abaqus_text.hpp"
#include "problems/files/meshes/mesh_data.hpp"
#include "problems/files/meshes/mesh_index.hpp"

namespace kusabi::problems {

class AbaqusGroups {
 public:
  AbaqusGroups(MeshData& mesh, MeshIndex& index) : mesh_(mesh), index_(index) {}

  /// Names of analytical rigid surfaces of a part, which have no elements.
  const std::set<std::string, std::less<>>& analytical() const { return analytical_; }
  void add_analytical(const std::string& name) { analytical_.insert(capitals(full_name(name))); }

  /// Adds an instance and enters it. @throws InputError if there is one of this name
  void begin_instance(const AbaqusText& text, const std::string& name);
  /// Tags and names are those of this instance from now on; 0: the assembly.
  void enter(int instance) { index_.enter(instance); }
  /// The name of a group of the current instance: "peg-1.left".
  std::string full_name(const std::string& name) const;

  /// The group with a name in the current instance; it is created if there is none.
  MeshGroup& group(const AbaqusText& text, const std::string& name, MeshPlace at);

  /// The nodes of a set, or a single node, named by a field of the line: "left", "17", or, from the
  /// assembly, "peg-1.left", "peg-1.17".
  std::vector<int> nodes(const MeshText& line, std::size_t field) const;
  /// The elements of a set, or a single element, named by a field of the line.
  std::vector<int> elements(const MeshText& line, std::size_t field) const;
  /// The group or the rigid surface that a field names, from the assembly: its name as the file
  /// spells it first; empty for an analytical rigid surface.
  std::string surface_name(const MeshText& line, std::size_t field) const;
  /// The node set that a parameter names.
  const MeshGroup& node_set(const AbaqusText& text, const std::string& name) const;
  /// The element set that a parameter names.
  const MeshGroup& element_set(const AbaqusText& text, const std::string& name) const;

  void read_node_set(AbaqusText& text, const AbaqusCard& card);
  void read_element_set(AbaqusText& text, const AbaqusCard& card);
  void read_surface(AbaqusText& text, const AbaqusCard& card);

 private:
  const MeshGroup* find(std::string_view name) const;
  /// Index in `MeshData::instances`; -1 if there is none.
  int find_instance(std::string_view name) const;
  /// The instance that a parameter names; the current one without it.
  int instance_of(const AbaqusText& text, const AbaqusCard& card) const;
  /// The instance and the tag of a field "peg-1.17"; nothing if it is not of this form.
  std::optional<std::pair<int, int>> tag_of_instance(std::string_view field) const;
  static bool is_set(const MeshGroup* group, std::vector<int> MeshGroup::*members);
  /// @throws InputError unless there is such a set
  const MeshGroup& set_of(const AbaqusText& text, const std::string& name, std::string_view kind,
                          std::vector<int> MeshGroup::*members) const;
  /// The members of the set that a field names. @param kind "node" or "element"
  const std::vector<int>& set_named(const MeshText& line, std::size_t field, std::string_view kind,
                                    std::vector<int> MeshGroup::*members) const;
  /// *NSET or *ELSET. @param read adds the members that the lines of the card name
  template <class Read>
  void read_group(AbaqusText& text, const AbaqusCard& card, std::string_view keyword,
                  std::vector<int> MeshGroup::*members, Read read);
  void read_face(const MeshText& line, MeshGroup& surface);
  /// @param all the group of a set and a surface  @throws InputError if their members differ
  void refuse_other_members(const AbaqusText& text, const std::string& name, const MeshGroup& all,
                            std::vector<int> MeshGroup::*members) const;

  MeshData& mesh_;
  MeshIndex& index_;
  std::map<std::string, std::size_t, std::less<>> numbers_;  // by name in capitals
  std::map<std::string, MeshGroup, std::less<>> surfaces_;   // own members, by name in capitals
  std::set<std::string, std::less<>> analytical_;            // surfaces, by name in capitals
};

/// @throws InputError at a parameter that is not `allowed`
void allow_only(const AbaqusText& text, const AbaqusCard& card,
                std::initializer_list<std::string_view> allowed);

/// The value of a required parameter.
const std::string& required(const AbaqusText& text, const AbaqusCard& card, std::string_view name);

}  // namespace kusabi::problems
