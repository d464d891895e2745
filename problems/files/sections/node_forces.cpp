// Groups of nodes and forces.
#include "problems/files/sections/node_forces.hpp"

#include <fmt/format.h>

#include "problems/files/toml/toml_reader.hpp"
#include "support/nearest.hpp"

namespace kusabi::problems {
namespace {

Eigen::Index number_of(const TomlReader& reader, const TomlText& name, const Structure& structure) {
  if (const auto found = node_named(structure, name.text)) return *found;
  const auto& node_names = structure.node_names;
  const auto meant = support::nearest(name.text, {node_names.begin(), node_names.end()});
  reader.fail(
      name.position,
      fmt::format(
          "node {} does not exist; expected a node of the problem file{}",
          support::in_quotes(name.text),
          meant.empty() ? "" : fmt::format("; did you mean {}?", support::in_quotes(meant))));
}

}  // namespace

Eigen::MatrixXd read_node_forces(std::string_view toml_text, const std::string& file_name,
                                 const Structure& structure) {
  const int dimension = structure.dimension;
  const TomlReader reader(toml_text, file_name);
  const auto root = reader.root();
  reader.allow_only(root, {"loads"});
  Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(dimension, static_cast<Eigen::Index>(structure.node_names.size()));
  const auto& section = reader.require(root, "loads", "[[loads]] groups of nodes and force");
  for (const TomlTable& group : reader.groups(section, "loads")) {
    reader.allow_only(group, {"nodes", "force"});
    const auto& nodes = reader.require(group, "nodes", "nodes = [\"a\", ...]");
    const Eigen::VectorXd force =
        reader.vector(reader.require(group, "force", "force = [...], at each of the nodes"),
                      "the force", dimension);
    for (const TomlText& name : reader.texts(nodes, "nodes")) {
      forces.col(number_of(reader, name, structure)) += force;
    }
  }
  return forces;
}

}  // namespace kusabi::problems
