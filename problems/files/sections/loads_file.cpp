// Loads and uncertain loads, key by key.
#include "problems/files/sections/loads_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/checks/structure_check.hpp"

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

namespace {

/// A force with the half-widths of its components, which are zero for single numbers.
struct BoundedForce {
  Eigen::VectorXd middle;
  Eigen::VectorXd half_width;
};

// An upper bound of a - b: the difference or the next double.
double difference_above(double a, double b) {
  const double difference = a - b;
  const double taken = difference - a;
  const double lost = (a - (difference - taken)) - (b + taken);
  return lost > 0 ? std::nextafter(difference, std::numeric_limits<double>::infinity())
                  : difference;
}

// [lower, upper] as middle and half-width, which contain both bounds despite rounding.
std::pair<double, double> interval(const TomlReader& reader, const toml::node& node) {
  const auto ends = reader.elements(node, "a component of the force");
  if (ends.size() != 2) {
    reader.fail(node, fmt::format("a component of the force has {} ends; expected a number, or "
                                  "[lower, upper]",
                                  ends.size()));
  }
  const double lower = reader.number(*ends[0], "the lower end of a component of the force");
  const double upper = reader.number(*ends[1], "the upper end of a component of the force");
  if (lower >= upper) {
    reader.fail(node, fmt::format("a component of the force goes from {} to {}; expected [lower, "
                                  "upper], the first below the second",
                                  lower, upper));
  }
  const double middle = lower / 2 + upper / 2;
  return {middle, std::max(difference_above(upper, middle), difference_above(middle, lower))};
}

// Components as numbers or, where allowed, intervals.
BoundedForce bounded_force(const TomlReader& reader, const toml::node& node, int dimension,
                           Load::Kind kind) {
  const auto components = reader.elements(node, "the force");
  const auto bounded = [](const toml::node* each) { return each->is_array(); };
  if (std::ranges::none_of(components, bounded) ||
      components.size() != static_cast<std::size_t>(dimension)) {
    return {reader.vector(node, "the force", dimension), Eigen::VectorXd::Zero(dimension)};
  }
  BoundedForce force{Eigen::VectorXd::Zero(dimension), Eigen::VectorXd::Zero(dimension)};
  for (int axis = 0; axis < dimension; ++axis) {
    const toml::node* component = components[static_cast<std::size_t>(axis)];
    if (!bounded(component)) {
      force.middle(axis) = reader.number(*component, "a component of the force");
      continue;
    }
    if (kind == Load::Kind::reference) {
      reader.fail(*component,
                  "the reference load has an interval; expected a number: the load "
                  "factor multiplies it, the dead load is uncertain");
    }
    std::tie(force.middle(axis), force.half_width(axis)) = interval(reader, *component);
  }
  return force;
}

// The uncertain parameters read so far.
std::vector<UncertainParameter>& uncertain_in(Structure& structure) {
  if (!structure.uncertain) structure.uncertain.emplace();
  return *structure.uncertain;
}

// The half-width of the parameters of a group, if specified.
std::optional<double> half_width_in(const TomlReader& reader, const TomlTable& group) {
  const toml::node* entry = group.table->get("alpha");
  if (entry == nullptr) return {};
  return reader.positive(*entry, "alpha", "half-width", smallest_magnitude, largest_magnitude);
}

// The name of the group under `key`; empty if there is none.
std::string name_in(const TomlReader& reader, const TomlTable& group, std::string_view key) {
  const toml::node* entry = group.table->get(key);
  return entry == nullptr ? std::string() : reader.text(*entry, key).text;
}

}  // namespace

std::vector<ForceComponent> force_components(const TomlReader& reader, const toml::node& forces,
                                             const NodeLister& nodes, int dimension) {
  std::vector<ForceComponent> components;
  for (const toml::node* each : reader.elements(forces, "forces")) {
    const TomlTable entry = reader.table(*each, "one of the forces");
    reader.allow_only(entry, {"nodes", "except", "every", "force"});
    reader.require(entry, "nodes", "nodes = [\"a\", ...]");
    const Eigen::VectorXd force =
        reader.vector(reader.require(entry, "force", "force = [...], at each of the nodes"),
                      "the force", dimension);
    for (const ListedNode& listed : nodes(entry)) {
      for (int axis = 0; axis < dimension; ++axis) {
        if (force(axis) == 0) continue;
        components.push_back({listed.node, axis, force(axis), listed.position});
      }
    }
  }
  return components;
}

void LoadsFile::read_loads(const toml::node& section, Structure& structure) const {
  for (const TomlTable& group : reader_.groups(section, "loads")) load_group(group, structure);
}

void LoadsFile::load_group(const TomlTable& group, Structure& structure) const {
  reader_.allow_only(group, {"kind", "nodes", "except", "every", "force", "case"});
  const TomlText kind =
      reader_.text(reader_.require(group, "kind", "kind = \"dead\" or \"reference\""), "kind");
  if (kind.text != "dead" && kind.text != "reference") {
    reader_.fail(kind.position, fmt::format("kind is {}; expected \"dead\" or \"reference\"",
                                            support::in_quotes(kind.text)));
  }
  reader_.require(group, "nodes", "nodes = [\"a\", ...]");
  const auto which = kind.text == "dead" ? Load::Kind::dead : Load::Kind::reference;
  const auto [force, half_width] =
      bounded_force(reader_, reader_.require(group, "force", "force = [...], at each of the nodes"),
                    structure.dimension, which);
  const auto load_case = name_in(reader_, group, "case");
  for (const ListedNode& listed : nodes_(group)) {
    structure.loads.push_back({which, listed.node, force, load_case});
    structure.sources.loads.push_back(listed.position);
    for (int axis = 0; axis < structure.dimension; ++axis) {
      if (half_width(axis) == 0) continue;
      uncertain_in(structure).push_back(
          {{}, {{listed.node, axis, 1}}, half_width(axis), {}, load_case});
      structure.sources.uncertain.push_back(listed.position);
    }
  }
}

void LoadsFile::read_uncertainty(const toml::node& section, Structure& structure) const {
  uncertain_in(structure);
  for (const TomlTable& group : reader_.groups(section, "uncertainty")) {
    uncertainty_group(group, structure);
  }
}

// One parameter that acts on several components.
void LoadsFile::uncertain_load(const TomlTable& group, Structure& structure) const {
  reader_.allow_only(group, {"name", "forces", "alpha", "group", "case"});
  const TomlText name =
      reader_.text(reader_.require(group, "name", "name = \"...\", of the uncertain load"), "name");
  const auto& forces =
      reader_.require(group, "forces", "forces = [{ nodes = [\"a\", ...], force = [...] }, ...]");
  UncertainParameter parameter{name.text,
                               {},
                               half_width_in(reader_, group),
                               name_in(reader_, group, "group"),
                               name_in(reader_, group, "case")};
  for (const auto& [node, axis, force, position] :
       force_components(reader_, forces, nodes_, structure.dimension)) {
    parameter.components.push_back({node, axis, force});
    structure.sources.uncertain.push_back(position);
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
  reader_.allow_only(group,
                     {"nodes", "except", "every", "axes", "weight", "alpha", "group", "case"});
  reader_.require(group, "nodes", "nodes = [\"a\", ...]");
  const auto axes = axes_in(reader_, reader_.require(group, "axes", "axes = [\"x\", ...]"), "axes",
                            structure.dimension);
  double weight = 1;
  if (const toml::node* entry = group.table->get("weight"); entry != nullptr) {
    weight = reader_.number(*entry, "weight");
  }
  const auto half_width = half_width_in(reader_, group);
  const auto name = name_in(reader_, group, "group");
  const auto load_case = name_in(reader_, group, "case");
  for (const ListedNode& listed : nodes_(group)) {
    for (int axis = 0; axis < structure.dimension; ++axis) {
      if (!axes[static_cast<std::size_t>(axis)]) continue;
      structure.uncertain->push_back(
          {{}, {{listed.node, axis, weight}}, half_width, name, load_case});
      structure.sources.uncertain.push_back(listed.position);
    }
  }
}

}  // namespace kusabi::problems
