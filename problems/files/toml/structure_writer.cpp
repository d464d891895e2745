// Writer of a problem file, section by section (docs/problem-files.md).
#include "problems/files/toml/structure_writer.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/files/toml/toml_text.hpp"

namespace kusabi::problems {
namespace {

std::string key(const std::string& name) {
  const bool bare = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return c < 128 && (std::isalnum(c) != 0 || c == '-' || c == '_');
  });
  return bare && !name.empty() ? name : toml_text(name);
}

std::string name_text(const Structure& structure, int node) {
  return toml_text(structure.node_names[static_cast<std::size_t>(node)]);
}

std::string vector_text(const Eigen::VectorXd& numbers) {
  return fmt::format("[{}]", fmt::join(numbers.begin(), numbers.end(), ", "));
}

// Calls `write(first, last)` for each run of `alike` entries, which form one section.
template <class Alike, class Write>
void by_runs(std::size_t count, Alike alike, Write write) {
  for (std::size_t first = 0; first < count;) {
    std::size_t last = first + 1;
    while (last < count && alike(first, last)) ++last;
    write(first, last);
    first = last;
  }
}

std::string yield_text(const YieldForces& yield) {
  if (yield.tension == yield.compression) return fmt::format("yield = {}\n", yield.tension);
  return fmt::format("yield = {{ tension = {}, compression = {} }}\n", yield.tension,
                     yield.compression);
}

void write_members(const Structure& structure, std::string& text) {
  const auto& members = structure.members;
  by_runs(
      members.size(),
      [&](auto a, auto b) {
        return members[a].axial_stiffness == members[b].axial_stiffness &&
               members[a].yield == members[b].yield;
      },
      [&](auto first, auto last) {
        std::vector<std::string> pairs;
        for (auto i = first; i < last; ++i) {
          pairs.push_back(fmt::format("[{}, {}]", name_text(structure, members[i].first),
                                      name_text(structure, members[i].second)));
        }
        text += "\n[[members]]\n";
        if (members[first].axial_stiffness != 0) {
          text += fmt::format("EA = {}\n", members[first].axial_stiffness);
        }
        if (members[first].yield) text += yield_text(*members[first].yield);
        text += fmt::format("between = {}\n", toml_list(pairs));
      });
}

void write_elements(const Structure& structure, std::string& text) {
  const auto& elements = structure.elements;
  const auto material = [&](auto i) {
    return std::tuple(elements[i].modulus, elements[i].ratio, elements[i].thickness,
                      elements[i].state);
  };
  by_runs(
      elements.size(), [&](auto a, auto b) { return material(a) == material(b); },
      [&](auto first, auto last) {
        std::vector<std::string> groups;
        for (auto i = first; i < last; ++i) {
          std::vector<std::string> names;
          for (const int node : elements[i].nodes) names.push_back(name_text(structure, node));
          groups.push_back(fmt::format("[{}]", fmt::join(names, ", ")));
        }
        text += fmt::format("\n[[elements]]\nE = {}\nnu = {}\n", elements[first].modulus,
                            elements[first].ratio);
        if (structure.dimension == 2) {
          text += fmt::format("thickness = {}\nplane = \"{}\"\n", elements[first].thickness,
                              elements[first].state == PlaneState::stress ? "stress" : "strain");
        }
        text += fmt::format("between = {}\n", toml_list(groups));
      });
}

void write_supports(const Structure& structure, std::string& text) {
  const auto d = static_cast<std::size_t>(structure.dimension);
  std::vector<std::array<bool, 3>> kinds;  // in the order of occurrence
  for (const auto& fixed : structure.fixed) {
    const bool any = std::any_of(fixed.begin(), fixed.begin() + structure.dimension,
                                 [](bool axis) { return axis; });
    if (any && std::find(kinds.begin(), kinds.end(), fixed) == kinds.end()) kinds.push_back(fixed);
  }
  for (const auto& kind : kinds) {
    std::vector<std::string> names;
    for (std::size_t node = 0; node < structure.fixed.size(); ++node) {
      if (structure.fixed[node] == kind) names.push_back(toml_text(structure.node_names[node]));
    }
    text += fmt::format("\n[[supports]]\nnodes = {}\n", toml_list(names));
    std::vector<std::string> axes;
    constexpr std::array axis_names{"\"x\"", "\"y\"", "\"z\""};
    for (std::size_t axis = 0; axis < d; ++axis) {
      if (kind[axis]) axes.emplace_back(axis_names[axis]);
    }
    if (axes.size() < d) text += fmt::format("fixed = {}\n", toml_list(axes));
  }
}

std::string place_text(const Structure& structure, const std::vector<WeightedNode>& place) {
  std::vector<std::string> names;
  std::vector<double> weights;
  for (const auto& [node, weight] : place) {
    names.push_back(name_text(structure, node));
    weights.push_back(weight);
  }
  return fmt::format("{{ nodes = [{}], weights = [{}] }}", fmt::join(names, ", "),
                     fmt::join(weights, ", "));
}

// One group for each entry, since directions and places differ from node to node.
void write_inclined(const Structure& structure, std::string& text) {
  for (const auto& [node, direction] : structure.inclined) {
    text += fmt::format("\n[[supports]]\nnodes = [{}]\ndirection = {}\n",
                        name_text(structure, node), vector_text(direction));
  }
}

void write_ties(const Structure& structure, std::string& text) {
  for (const auto& [node, to] : structure.ties) {
    text += fmt::format("\n[[ties]]\nnodes = [{}]\nto = [{}]\n", name_text(structure, node),
                        place_text(structure, to));
  }
}

void write_springs(const Structure& structure, std::string& text) {
  const auto& springs = structure.springs;
  by_runs(
      springs.size(),
      [&](auto a, auto b) {
        return springs[a].axis == springs[b].axis && springs[a].stiffness == springs[b].stiffness;
      },
      [&](auto first, auto last) {
        std::vector<std::string> names;
        for (auto i = first; i < last; ++i) {
          names.push_back(name_text(structure, springs[i].node));
        }
        text +=
            fmt::format("\n[[springs]]\nnodes = {}\naxes = [\"{}\"]\nstiffness = {}\n",
                        toml_list(names), axis_name(springs[first].axis), springs[first].stiffness);
      });
}

void write_contact(const Structure& structure, std::string& text) {
  const auto& contact = structure.contact;
  by_runs(
      contact.size(),
      [&](auto a, auto b) {
        return contact[a].normal == contact[b].normal && contact[a].tangent == contact[b].tangent &&
               contact[a].friction == contact[b].friction &&
               contact[a].surface == contact[b].surface &&
               contact[a].against.empty() == contact[b].against.empty();
      },
      [&](auto first, auto last) {
        std::vector<std::string> names;
        std::vector<std::string> places;
        for (auto i = first; i < last; ++i) {
          names.push_back(name_text(structure, contact[i].node));
          places.push_back(place_text(structure, contact[i].against));
        }
        text += fmt::format("\n[[contact]]\nnodes = {}\nnormal = {}\n", toml_list(names),
                            vector_text(contact[first].normal));
        if (!contact[first].surface.empty())
          text += fmt::format("name = {}\n", toml_text(contact[first].surface));
        if (!contact[first].against.empty())
          text += fmt::format("against = {}\n", toml_list(places));
        if (contact[first].tangent) {
          text += fmt::format("tangent = {}\n", vector_text(*contact[first].tangent));
        }
        if (contact[first].friction != 1) {
          text += fmt::format("friction_factor = {}\n", contact[first].friction);
        }
      });
}

std::string case_text(const std::string& load_case) {
  return load_case.empty() ? "" : fmt::format("case = {}\n", toml_text(load_case));
}

void write_loads(const Structure& structure, std::string& text) {
  const auto& loads = structure.loads;
  by_runs(
      loads.size(),
      [&](auto a, auto b) {
        return loads[a].kind == loads[b].kind && loads[a].force == loads[b].force &&
               loads[a].load_case == loads[b].load_case;
      },
      [&](auto first, auto last) {
        std::vector<std::string> names;
        for (auto i = first; i < last; ++i) {
          names.push_back(name_text(structure, loads[i].node));
        }
        text += fmt::format("\n[[loads]]\nkind = \"{}\"\nnodes = {}\nforce = {}\n",
                            loads[first].kind == Load::Kind::dead ? "dead" : "reference",
                            toml_list(names), vector_text(loads[first].force));
        text += case_text(loads[first].load_case);
      });
}

std::string half_width_text(const UncertainParameter& parameter) {
  std::string text;
  if (parameter.half_width) text += fmt::format("alpha = {}\n", *parameter.half_width);
  if (!parameter.group.empty()) text += fmt::format("group = {}\n", toml_text(parameter.group));
  return text + case_text(parameter.load_case);
}

// One force for each node; nodes that are not named have none.
void write_uncertain_load(const Structure& structure, const UncertainParameter& parameter,
                          std::string& text) {
  text += fmt::format("\n[[uncertainty]]\nname = {}\nforces = [\n", toml_text(parameter.name));
  const auto& components = parameter.components;
  by_runs(
      components.size(), [&](auto a, auto b) { return components[a].node == components[b].node; },
      [&](auto first, auto last) {
        Eigen::VectorXd force = Eigen::VectorXd::Zero(structure.dimension);
        for (auto i = first; i < last; ++i) force(components[i].axis) = components[i].weight;
        text += fmt::format("  {{ nodes = [{}], force = {} }},\n",
                            name_text(structure, components[first].node), vector_text(force));
      });
  text += "]\n" + half_width_text(parameter);
}

// One group for each parameter: lists of uncertain loads are short, or omitted.
void write_uncertainty(const Structure& structure, std::string& text) {
  if (!structure.uncertain) return;
  for (const auto& parameter : *structure.uncertain) {
    if (!parameter.name.empty()) {
      write_uncertain_load(structure, parameter, text);
      continue;
    }
    const auto& [node, axis, weight] = parameter.components.front();
    text += fmt::format("\n[[uncertainty]]\nnodes = [{}]\naxes = [\"{}\"]\nweight = {}\n",
                        name_text(structure, node), axis_name(axis), weight) +
            half_width_text(parameter);
  }
}

}  // namespace

std::string structure_text(const Structure& structure) {
  std::string text =
      fmt::format("name = {}\ndimension = {}\nunits = {{ length = {}, force = {} }}\n\n[nodes]\n",
                  toml_text(structure.name), structure.dimension, toml_text(structure.units.length),
                  toml_text(structure.units.force));
  for (std::size_t node = 0; node < structure.node_names.size(); ++node) {
    text += fmt::format("{} = {}\n", key(structure.node_names[node]),
                        vector_text(structure.coordinates.col(static_cast<Eigen::Index>(node))));
  }
  write_members(structure, text);
  write_elements(structure, text);
  write_supports(structure, text);
  write_inclined(structure, text);
  write_ties(structure, text);
  write_springs(structure, text);
  write_contact(structure, text);
  write_loads(structure, text);
  write_uncertainty(structure, text);
  return text;
}

}  // namespace kusabi::problems
