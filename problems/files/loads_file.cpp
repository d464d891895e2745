// Loads and what is uncertain about them, key by key.
#include "problems/files/loads_file.hpp"

#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace kusabi::problems {

std::array<bool, 3> axes_in(const TomlReader& reader, const toml::node& node,
                            std::string_view called, int dimension) {
  std::array<bool, 3> axes{};
  for (const TomlText& name : reader.texts(node, called)) {
    std::size_t axis = 0;
    while (axis < static_cast<std::size_t>(dimension) &&
           name.text != axis_name(static_cast<int>(axis))) {
      ++axis;
    }
    if (axis == static_cast<std::size_t>(dimension)) {
      reader.fail(name.position, fmt::format("{} names the axis {}; expected {} in {} dimensions",
                                             called, support::in_quotes(name.text),
                                             dimension == 2 ? "x or y" : "x, y or z", dimension));
    }
    if (axes[axis]) {
      reader.fail(name.position, fmt::format("{} names the axis {} twice; expected once", called,
                                             support::in_quotes(name.text)));
    }
    axes[axis] = true;
  }
  return axes;
}

YieldForces yield_in(const TomlReader& reader, const toml::node& node) {
  if (node.is_number()) {
    const double force = reader.number(node, "yield");
    return {force, force};
  }
  if (!node.is_table()) {
    reader.fail(node,
                "yield is neither a number nor a table; expected yield = 800 or "
                "yield = { tension = 800, compression = 500 }");
  }
  const TomlTable table = reader.table(node, "yield");
  reader.allow_only(table, {"tension", "compression"});
  const auto force = [&](std::string_view key) {
    return reader.number(reader.require(table, key, "a yield force"), key);
  };
  return {force("tension"), force("compression")};
}

void LoadsFile::read_loads(const toml::node& section, Structure& structure) const {
  for (const TomlTable& group : reader_.groups(section, "loads")) load_group(group, structure);
}

void LoadsFile::load_group(const TomlTable& group, Structure& structure) const {
  reader_.allow_only(group, {"kind", "nodes", "except", "every", "force"});
  const TomlText kind =
      reader_.text(reader_.require(group, "kind", "kind = \"dead\" or \"reference\""), "kind");
  if (kind.text != "dead" && kind.text != "reference") {
    reader_.fail(kind.position, fmt::format("kind is {}; expected \"dead\" or \"reference\"",
                                            support::in_quotes(kind.text)));
  }
  reader_.require(group, "nodes", "nodes = [\"a\", ...]");
  const Eigen::VectorXd force =
      reader_.vector(reader_.require(group, "force", "force = [...], at each of the nodes"),
                     "the force", structure.dimension);
  for (const ListedNode& listed : nodes_(group)) {
    structure.loads.push_back(
        {kind.text == "dead" ? Load::Kind::dead : Load::Kind::reference, listed.node, force});
    structure.sources.loads.push_back(listed.position);
  }
}

void LoadsFile::read_uncertainty(const toml::node& section, Structure& structure) const {
  structure.uncertain.emplace();
  for (const TomlTable& group : reader_.groups(section, "uncertainty")) {
    uncertainty_group(group, structure);
  }
}

// One parameter that acts on several components.
void LoadsFile::uncertain_load(const TomlTable& group, Structure& structure) const {
  reader_.allow_only(group, {"name", "forces"});
  const TomlText name =
      reader_.text(reader_.require(group, "name", "name = \"...\", of the uncertain load"), "name");
  const auto& forces =
      reader_.require(group, "forces", "forces = [{ nodes = [\"a\", ...], force = [...] }, ...]");
  UncertainParameter parameter{name.text, {}};
  for (const toml::node* each : reader_.elements(forces, "forces")) {
    const TomlTable entry = reader_.table(*each, "one of the forces");
    reader_.allow_only(entry, {"nodes", "except", "every", "force"});
    reader_.require(entry, "nodes", "nodes = [\"a\", ...]");
    const Eigen::VectorXd force =
        reader_.vector(reader_.require(entry, "force", "force = [...], at each of the nodes"),
                       "the force", structure.dimension);
    for (const ListedNode& listed : nodes_(entry)) {
      for (int axis = 0; axis < structure.dimension; ++axis) {
        if (force(axis) == 0) continue;
        parameter.components.push_back({listed.node, axis, force(axis)});
        structure.sources.uncertain.push_back(listed.position);
      }
    }
  }
  if (parameter.components.empty()) {
    reader_.fail(name.position, fmt::format("the uncertain load {} is zero; expected a force that "
                                            "is not",
                                            support::in_quotes(name.text)));
  }
  structure.uncertain->push_back(std::move(parameter));
}

void LoadsFile::uncertainty_group(const TomlTable& group, Structure& structure) const {
  if (group.table->contains("forces") || group.table->contains("name")) {
    uncertain_load(group, structure);
    return;
  }
  reader_.allow_only(group, {"nodes", "except", "every", "axes", "weight"});
  reader_.require(group, "nodes", "nodes = [\"a\", ...]");
  const auto axes = axes_in(reader_, reader_.require(group, "axes", "axes = [\"x\", ...]"), "axes",
                            structure.dimension);
  double weight = 1;
  if (const toml::node* entry = group.table->get("weight"); entry != nullptr) {
    weight = reader_.number(*entry, "weight");
  }
  for (const ListedNode& listed : nodes_(group)) {
    for (int axis = 0; axis < structure.dimension; ++axis) {
      if (!axes[static_cast<std::size_t>(axis)]) continue;
      structure.uncertain->push_back({{}, {{listed.node, axis, weight}}});
      structure.sources.uncertain.push_back(listed.position);
    }
  }
}

}  // namespace kusabi::problems
