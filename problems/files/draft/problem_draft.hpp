// Structure during the reading of its file: each section adds to it and refers to its nodes by
// name.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "problems/files/draft/facet_warning.hpp"
#include "problems/files/meshes/mesh_texts.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// A named part of the structure: its nodes and, if it consists of faces of elements, these faces
/// by their vertices in ascending order.
struct NamedGroup {
  std::vector<int> nodes;
  std::set<std::vector<int>> faces;
};

/// The nodes of a mesh, in its order, and the range of its elements.
struct NamedMesh {
  std::vector<int> nodes;
  std::size_t first_element = 0;
  std::size_t elements = 0;
};

/// A node of a list in the file, with the place of its name.
struct ListedNode {
  int node;
  support::SourcePosition position;
  std::string group{};  ///< the name in the list if it stands for several nodes
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
  /// The name in quotes, for messages.
  std::string node_name(int node) const;

  /// Adds a node without supports. @return its number
  int add_node(const std::string& name, const Eigen::VectorXd& place,
               support::SourcePosition position);
  /// Adds a second name for a node.
  void add_name(const std::string& name, int node);
  /// Adds a name for several nodes in lists of nodes.
  void add_group(const std::string& name, NamedGroup group);
  void add_mesh(const std::string& name, NamedMesh mesh) { meshes_named_.emplace(name, mesh); }
  /// The mesh with a name; null if there is none.
  const NamedMesh* mesh(const std::string& name) const;
  bool names_node(const std::string& name) const { return node_numbers_.contains(name); }
  bool names_group(const std::string& name) const { return groups_.contains(name); }

  /// @throws InputError if there is no node with this name
  int node(const TomlText& name) const;
  /// The nodes of an entry of a list: one, or those of a group.
  std::vector<int> nodes_named(const TomlText& name) const;
  /// The group with a name; null if there is none.
  const NamedGroup* group(const std::string& name) const;
  /// The nodes that `nodes` of a table lists, in the order of the file, without those of `except`,
  /// and of the rest the first of each `every`.
  std::vector<ListedNode> nodes_listed(const TomlTable& table) const;

  /// Adds a file of the structure. @return `SourcePosition::file` of its entries
  int add_file(const std::string& name);

  /// Normals that are means over faces, one entry for each contact group.
  std::vector<FacetWarning>& facets() { return facets_; }

  /// Supports a node along some axes.
  /// @throws InputError if it is supported already
  void support(const ListedNode& node, const std::array<bool, 3>& fixed);

  /// Displacements of supported nodes, d each.
  std::map<int, Eigen::VectorXd>& displaced() { return displaced_; }

  /// The structure, after all sections are read.
  Structure finished() &&;

 private:
  /// Suggestion for an unknown name: the most similar one, the group of a mesh with this name, or
  /// the groups of the named mesh. Empty, or begins with a semicolon.
  std::string names_instead(const std::string& name) const;

  TomlReader reader_;
  MeshTexts meshes_;
  Structure structure_;
  std::map<std::string, int, std::less<>> node_numbers_;
  std::map<std::string, NamedGroup, std::less<>> groups_;
  std::map<std::string, NamedMesh, std::less<>> meshes_named_;
  std::map<int, support::SourcePosition> supported_;
  std::vector<FacetWarning> facets_;
  std::map<int, Eigen::VectorXd> displaced_;
};

/// Names in messages: the first dozen in quotes, and the number of the others.
std::string names_of_groups(std::vector<std::string> groups, std::string_view between);

}  // namespace kusabi::problems
