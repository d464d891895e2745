// Problem file that is written from a deck: its text so far, and the names of nodes in it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/files/meshes/mesh_data.hpp"

namespace kusabi::problems {

/// A group of the mesh and the selected ones of its nodes.
struct ChosenNodes {
  std::string group;  ///< empty: the nodes are listed one by one
  std::vector<int> all;
  std::vector<int> chosen;
};

class DeckDraft {
 public:
  /// @param prefix name of the [[mesh]]
  DeckDraft(const MeshData& mesh, std::string prefix);

  const MeshData& mesh() const { return mesh_; }
  int dimension() const { return dimension_; }
  const Eigen::MatrixXd& places() const { return places_; }

  /// True for nodes of the body or of a bar; others are not in the problem.
  bool is_used(int node) const { return used_[static_cast<std::size_t>(node)]; }
  /// True for elements with the dimension of the problem.
  bool is_body(const MeshElement& element) const {
    return mesh_dimension(element.shape) == dimension_;
  }

  /// The group with a name; null if there is none.
  const MeshGroup* group(const std::string& name) const;
  /// The used nodes of a group, all of them selected.
  ChosenNodes nodes_of(const MeshGroup& group) const;
  /// The nodes of a surface: those of its faces, if it has some. A set of the same name may have
  /// other nodes; then they are listed one by one.
  ChosenNodes nodes_of_surface(const MeshGroup& group) const;

  /// Name of a node or of a group in the problem file.
  std::string name(int node) const;
  std::string name(const std::string& group) const { return prefix_ + "." + group; }
  /// The lines `nodes = ...` and `except = ...`, as short as they can be.
  std::string lines(const ChosenNodes& nodes) const;
  /// "line 12 of wedge.inp".
  std::string line(MeshPlace at) const;

  void write(const std::string& text) { text_ += text; }
  void warn(MeshPlace at, const std::string& message);
  const std::string& text() const { return text_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

  std::set<int> tied;  ///< nodes of the ties written so far

 private:
  const MeshData& mesh_;
  std::string prefix_;
  int dimension_ = 2;
  Eigen::MatrixXd places_;  // d x nodes
  std::vector<bool> used_;
  std::string text_;
  std::vector<std::string> warnings_;
};

}  // namespace kusabi::problems
