// Sections of a problem file for limit analysis: [[loads]] and [[uncertainty]]
// (docs/problem-files.md).
#pragma once

#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "problems/files/draft/problem_draft.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// A list of axis names as flags, without repetitions.
/// @param called the key, for messages
std::array<bool, 3> axes_in(const TomlReader& reader, const toml::node& node,
                            std::string_view called, int dimension);

/// Function from a table to its listed nodes. @throws InputError
using NodeLister = std::function<std::vector<ListedNode>(const TomlTable&)>;

/// Component of a force at a node, not zero.
struct ForceComponent {
  int node;
  int axis;
  double force;
  support::SourcePosition position;  ///< of the node in its list
};

/// The components of a list [{ nodes = [...], force = [...] }, ...], in its order; a component may
/// occur more than once.
std::vector<ForceComponent> force_components(const TomlReader& reader, const toml::node& forces,
                                             const NodeLister& nodes, int dimension);

class LoadsFile {
 public:
  LoadsFile(const TomlReader& reader, NodeLister nodes)
      : reader_(reader), nodes_(std::move(nodes)) {}

  /// Adds the loads of [[loads]] to the structure, and an uncertain parameter for each component
  /// that is an interval.
  void read_loads(const toml::node& section, Structure& structure) const;

  /// Adds the uncertain parameters of [[uncertainty]].
  void read_uncertainty(const toml::node& section, Structure& structure) const;

 private:
  void load_group(const TomlTable& group, Structure& structure) const;
  void uncertainty_group(const TomlTable& group, Structure& structure) const;
  void uncertain_load(const TomlTable& group, Structure& structure) const;

  const TomlReader& reader_;
  NodeLister nodes_;
};

}  // namespace kusabi::problems
