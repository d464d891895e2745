// Sections [[supports]] and [[springs]]: supported nodes, springs, and their axes.
#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "problems/files/sections/loads_file.hpp"
#include "problems/files/sections/problem_sections.hpp"

namespace kusabi::problems {
namespace {

std::array<bool, 3> fixed_axes(const TomlReader& reader, const TomlTable& group, int dimension) {
  const toml::node* entry = group.table->get("fixed");
  if (entry != nullptr) return axes_in(reader, *entry, "fixed", dimension);
  std::array<bool, 3> fixed{};
  std::fill_n(fixed.begin(), dimension, true);
  return fixed;
}

// Supports the displacement along one direction. Along an axis it is a roller.
void inclined_group(ProblemDraft& draft, const TomlTable& group, const toml::node& entry) {
  const TomlReader& reader = draft.reader();
  Structure& structure = draft.structure();
  if (const toml::node* moved = group.table->get("displacement"); moved != nullptr)
    reader.fail(*moved, "displacement and direction in one group; expected fixed axes");
  if (const toml::node* fixed = group.table->get("fixed"); fixed != nullptr) {
    reader.fail(*fixed, "fixed and direction in one group; expected one of the two");
  }
  const Eigen::VectorXd direction = reader.vector(entry, "direction", structure.dimension);
  if (direction.isZero(0.0)) {
    reader.fail(entry,
                "the direction is zero; expected the one along which the nodes are "
                "supported");
  }
  std::array<bool, 3> fixed{};
  const bool axis = (direction.array() != 0).count() == 1;
  for (int i = 0; axis && i < structure.dimension; ++i)
    fixed[static_cast<std::size_t>(i)] = direction(i) != 0;
  for (const ListedNode& node : draft.nodes_listed(group)) {
    draft.support(node, fixed);
    if (axis) continue;
    structure.inclined.push_back({node.node, direction});
    structure.sources.inclined.push_back(node.position);
  }
}

// The prescribed displacement of supported nodes, zero along axes that are not fixed.
Eigen::VectorXd displacement(const TomlReader& reader, const TomlTable& group,
                             const std::array<bool, 3>& fixed, int dimension) {
  const toml::node* entry = group.table->get("displacement");
  if (entry == nullptr) return Eigen::VectorXd::Zero(dimension);
  const Eigen::VectorXd moved = reader.vector(*entry, "displacement", dimension);
  for (int axis = 0; axis < dimension; ++axis) {
    if (moved(axis) != 0 && !fixed[static_cast<std::size_t>(axis)])
      reader.fail(*entry, fmt::format("displacement along {}, which is not fixed; expected 0 there",
                                      axis_name(axis)));
  }
  return moved;
}

}  // namespace

void read_supports(ProblemDraft& draft) {
  const TomlReader& reader = draft.reader();
  const toml::node* section = draft.section("supports");
  if (section == nullptr) return;
  for (const TomlTable& group : reader.groups(*section, "supports")) {
    reader.allow_only(group, {"nodes", "except", "every", "fixed", "direction", "displacement"});
    reader.require(group, "nodes", "nodes = [\"a\", ...]");
    if (const toml::node* direction = group.table->get("direction"); direction != nullptr) {
      inclined_group(draft, group, *direction);
      continue;
    }
    const auto fixed = fixed_axes(reader, group, draft.structure().dimension);
    const auto moved = displacement(reader, group, fixed, draft.structure().dimension);
    for (const ListedNode& node : draft.nodes_listed(group)) {
      draft.support(node, fixed);
      if (!moved.isZero(0)) draft.displaced().emplace(node.node, moved);
    }
  }
}

void read_springs(ProblemDraft& draft) {
  const TomlReader& reader = draft.reader();
  const toml::node* section = draft.section("springs");
  if (section == nullptr) return;
  Structure& structure = draft.structure();
  for (const TomlTable& group : reader.groups(*section, "springs")) {
    reader.allow_only(group, {"nodes", "except", "every", "axes", "stiffness"});
    reader.require(group, "nodes", "nodes = [\"a\", ...]");
    const auto& axes_entry = reader.require(group, "axes", "axes = [\"x\", ...]");
    const auto axes = axes_in(reader, axes_entry, "axes", structure.dimension);
    const double stiffness = reader.number(
        reader.require(group, "stiffness", "stiffness = a force per length"), "stiffness");
    for (const ListedNode& listed : draft.nodes_listed(group)) {
      for (int axis = 0; axis < structure.dimension; ++axis) {
        if (!axes[static_cast<std::size_t>(axis)]) continue;
        structure.springs.push_back({listed.node, axis, stiffness});
        structure.sources.springs.push_back(listed.position);
      }
    }
  }
}

}  // namespace kusabi::problems
