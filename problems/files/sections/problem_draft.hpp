// A structure while its file is read: its sections, one after another, add to it, and name its
// nodes by what stands here.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "problems/files/meshes/mesh_texts.hpp"
#include "problems/files/sections/facet_doubt.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// A part of the structure that has a name: its nodes, and the faces of elements that it is made
/// of, each by its corners in ascending order, if it is made of faces.
struct NamedGroup {
  std::vector<int> nodes;
  std::set<std::vector<int>> faces;
};

/// The nodes of a mesh, in its order, and which of the elements are its own.
struct NamedMesh {
  std::vector<int> nodes;
  std::size_t first_element = 0;
  std::size_t elements = 0;
};

/// A node of a list in the file, with the place of the name that stands for it.
struct ListedNode {
  int node;
  support::SourcePosition position;
  std::string group{};  ///< the name in the list, if it is that of several nodes
};

class ProblemDraft {
 public:
  /// @param meshes the texts of the files that it names
  ProblemDraft(std::string_view text, const std::string& file, MeshTexts meshes);

  const TomlReader& reader() const { return reader_; }
  const MeshTexts& meshes() const { return meshes_; }
  /// The section `name`; null if the file has none.
  const toml::node* section(std::string_view name) const;

  Structure& structure() { return structure_; }
  const Structure& structure() const { return structure_; }
  int node_count() const { return static_cast<int>(structure_.node_names.size()); }
  /// In quotes, for errors.
  std::string node_name(int node) const;

  /// A new node, which moves freely. Its number.
  int add_node(const std::string& name, const Eigen::VectorXd& place,
               support::SourcePosition position);
  /// Another name for a node.
  void add_name(const std::string& name, int node) { node_numbers_.emplace(name, node); }
  /// A name that stands for several nodes in lists of nodes.
  void add_group(const std::string& name, NamedGroup group);
  void add_mesh(const std::string& name, NamedMesh mesh) { meshes_named_.emplace(name, mesh); }
  /// The mesh of that name; null if there is none.
  const NamedMesh* mesh(const std::string& name) const;
  bool names_node(const std::string& name) const { return node_numbers_.contains(name); }
  bool names_group(const std::string& name) const { return groups_.contains(name); }

  /// @throws InputError if there is none of this name
  int node(const TomlText& name) const;
  /// The nodes that an entry of a list names: one, or those of a group.
  std::vector<int> nodes_named(const TomlText& name) const;
  /// The group of that name; null if there is none.
  const NamedGroup* group(const std::string& name) const;
  /// The nodes that `nodes` of a table lists, in the order of the file, without those of `except`,
  /// and of the others only the first of `every` so many.
  std::vector<ListedNode> nodes_listed(const TomlTable& table) const;

  /// A file that the structure is read of besides: `SourcePosition::file` of what stands in it.
  int add_file(const std::string& name);

  /// Of normals that are means of faces, a contact group each.
  std::vector<FacetDoubt>& facets() { return facets_; }

  /// Holds a node along some axes.
  /// @throws InputError if it is held already
  void support(const ListedNode& node, const std::array<bool, 3>& fixed);

  /// The structure, when all sections are read.
  Structure finished() &&;

 private:
  /// What to say of a name that does not exist: the nearest one, the group of a mesh that is called
  /// so, or the groups of the mesh that it names. Empty, or it begins with a semicolon.
  std::string names_instead(const std::string& name) const;

  TomlReader reader_;
  MeshTexts meshes_;
  Structure structure_;
  std::map<std::string, int, std::less<>> node_numbers_;
  std::map<std::string, NamedGroup, std::less<>> groups_;
  std::map<std::string, NamedMesh, std::less<>> meshes_named_;
  std::map<int, support::SourcePosition> supported_;
  std::vector<FacetDoubt> facets_;
};

/// For messages: the first dozen of them in quotes, and how many more there are.
std::string names_of_groups(std::vector<std::string> groups, std::string_view between);

}  // namespace kusabi::problems
