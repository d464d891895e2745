// Structure by parts. Lists of numbers take one line each, so nodes are referred to by index.
#include "run/pictures/structure_json.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/element_shape.hpp"
#include "run/output/values.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;
using problems::Structure;

void add_if_any(ordered_json& json, const char* name, ordered_json list) {
  if (!list.empty()) json[name] = std::move(list);
}

ordered_json positions_json(const Structure& structure) {
  auto list = ordered_json::array();
  for (const auto& position : structure.coordinates.colwise()) list.push_back(numbers(position));
  return list;
}

ordered_json members_json(const Structure& structure) {
  auto list = ordered_json::array();
  for (const auto& member : structure.members)
    list.push_back(std::array{member.first, member.second});
  return list;
}

// "a-b" for each member, as in the collapse modes of curves.
ordered_json member_names_json(const Structure& structure) {
  const auto name = [&](int node) { return structure.node_names[static_cast<std::size_t>(node)]; };
  auto list = ordered_json::array();
  for (const auto& member : structure.members)
    list.push_back(name(member.first) + '-' + name(member.second));
  return list;
}

// EA of each member, if given for all.
ordered_json axial_stiffnesses_json(const Structure& structure) {
  auto list = ordered_json::array();
  for (const auto& member : structure.members) {
    if (member.axial_stiffness == 0) return {};
    list.push_back(member.axial_stiffness);
  }
  return list;
}

// Elements by shape, in each shape in the order of the structure.
ordered_json elements_json(const std::vector<problems::Element>& all) {
  std::map<problems::ElementShape, std::vector<std::vector<int>>> by_shape;
  for (const auto& element : all) by_shape[element.shape].push_back(element.nodes);
  auto list = ordered_json::array();
  for (auto& [shape, nodes] : by_shape)
    list.push_back({{"shape", problems::shape_traits(shape).name}, {"nodes", std::move(nodes)}});
  return list;
}

// Distinct materials of the elements with the number of their elements, in the order of their first
// ones.
ordered_json materials_json(const Structure& structure) {
  auto list = ordered_json::array();
  std::map<std::tuple<double, double, double, problems::PlaneState>, std::size_t> places;
  for (const auto& element : structure.elements) {
    const bool plane = structure.dimension == 2;
    const auto [place, is_new] =
        places.try_emplace({element.modulus, element.ratio, plane ? element.thickness : 0,
                            plane ? element.state : problems::PlaneState::stress},
                           list.size());
    if (is_new) {
      list.push_back({{"E", element.modulus}, {"nu", element.ratio}, {"elements", 0}});
      if (plane) {
        list.back()["thickness"] = element.thickness;
        list.back()["plane"] = element.state == problems::PlaneState::stress ? "stress" : "strain";
      }
    }
    auto& count = list[place->second]["elements"];
    count = count.get<std::size_t>() + 1;
  }
  return list;
}

// Nodes fixed along x, along y, along z.
ordered_json fixed_json(const Structure& structure) {
  auto axes = ordered_json::object();
  for (int axis = 0; axis < structure.dimension; ++axis) {
    std::vector<std::size_t> nodes;
    for (std::size_t node = 0; node < structure.fixed.size(); ++node) {
      if (structure.fixed[node][static_cast<std::size_t>(axis)]) nodes.push_back(node);
    }
    if (!nodes.empty()) axes[std::string(problems::axis_name(axis))] = nodes;
  }
  return axes;
}

ordered_json inclined_supports_json(const Structure& structure) {
  auto list = ordered_json::array();
  for (const auto& [node, direction] : structure.inclined)
    list.push_back({{"node", node}, {"direction", numbers(direction)}});
  return list;
}

ordered_json springs_json(const Structure& structure) {
  auto list = ordered_json::array();
  for (const auto& [node, axis, stiffness] : structure.springs)
    list.push_back({{"node", node}, {"axis", problems::axis_name(axis)}, {"stiffness", stiffness}});
  return list;
}

ordered_json shares_json(const std::vector<problems::WeightedNode>& shares) {
  auto list = ordered_json::array();
  for (const auto& [node, weight] : shares) list.push_back({{"node", node}, {"weight", weight}});
  return list;
}

ordered_json ties_json(const Structure& structure) {
  auto list = ordered_json::array();
  for (const auto& [node, to] : structure.ties)
    list.push_back({{"node", node}, {"to", shares_json(to)}});
  return list;
}

ordered_json candidates_json(const Structure& structure) {
  auto list = ordered_json::array();
  for (const auto& candidate : structure.contact) list.push_back(candidate.node);
  return list;
}

// Nodes of the other body with weights, for each candidate; nothing if there is none.
ordered_json against_json(const Structure& structure) {
  auto list = ordered_json::array();
  bool any = false;
  for (const auto& candidate : structure.contact) {
    auto shares = shares_json(candidate.against);
    any = any || !shares.empty();
    list.push_back(std::move(shares));
  }
  return any ? list : ordered_json();
}

ordered_json loads_json(const Structure& structure, problems::Load::Kind kind) {
  auto list = ordered_json::array();
  for (const auto& load : structure.loads) {
    if (load.kind == kind) list.push_back({{"node", load.node}, {"force", numbers(load.force)}});
  }
  return list;
}

// q^t and q^c of each member, if given for all.
ordered_json yield_forces_json(const Structure& structure) {
  auto list = ordered_json::array();
  for (const auto& member : structure.members) {
    if (!member.yield) return {};
    list.push_back(std::array{member.yield->tension, member.yield->compression});
  }
  return list;
}

}  // namespace

std::vector<std::size_t> listed_elements(const Structure& structure) {
  std::vector<std::size_t> places(structure.elements.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::ranges::stable_sort(
      places, {}, [&](const std::size_t place) { return structure.elements[place].shape; });
  return places;
}

ordered_json structure_json(const Structure& structure) {
  ordered_json json{{"node_names", structure.node_names}, {"positions", positions_json(structure)}};
  add_if_any(json, "members", members_json(structure));
  add_if_any(json, "member_names", member_names_json(structure));
  add_if_any(json, "axial_stiffnesses", axial_stiffnesses_json(structure));
  add_if_any(json, "yield_forces", yield_forces_json(structure));
  add_if_any(json, "elements", elements_json(structure.elements));
  add_if_any(json, "materials", materials_json(structure));
  add_if_any(json, "outlines", elements_json(structure.outlines));
  add_if_any(json, "fixed", fixed_json(structure));
  add_if_any(json, "inclined_supports", inclined_supports_json(structure));
  add_if_any(json, "springs", springs_json(structure));
  add_if_any(json, "ties", ties_json(structure));
  add_if_any(json, "candidates", candidates_json(structure));
  add_if_any(json, "against", against_json(structure));
  add_if_any(json, "dead_loads", loads_json(structure, problems::Load::Kind::dead));
  add_if_any(json, "reference_loads", loads_json(structure, problems::Load::Kind::reference));
  return json;
}

namespace {

using problems::LimitProblem;

// T by columns: nodal forces of each uncertain load for a zeta of one unit of force.
ordered_json uncertain_loads_json(const LimitProblem& problem) {
  auto list = ordered_json::array();
  for (int j = 0; j < problem.uncertain_count(); ++j) {
    const auto& column = problem.uncertain[static_cast<std::size_t>(j)];
    auto components = ordered_json::array();
    for (const auto& [degree, value] : column.direction) {
      const auto& [node, axis] = problem.degrees.free[static_cast<std::size_t>(degree)];
      components.push_back({{"node", problem.node_names[static_cast<std::size_t>(node)]},
                            {"axis", problems::axis_name(axis)},
                            {"weight", column.weight * value}});
    }
    ordered_json load{{"name", problems::parameter_name(problem, j)},
                      {"components", std::move(components)}};
    if (column.in_file) load["half_width"] = column.half_width;
    list.push_back(std::move(load));
  }
  return list;
}

}  // namespace

ordered_json limit_problem_json(const LimitProblem& problem, const problems::Structure& truss,
                                const std::string& file) {
  return {{"file", file},
          {"name", problem.name},
          {"d", problem.dimension},
          {"m", problem.uncertain_count()},
          {"nodes", problem.node_names.size()},
          {"members", problem.member_count()},
          {"units", {{"length", problem.units.length}, {"force", problem.units.force}}},
          {"fingerprint", hexadecimal(problem.fingerprint)},
          {"uncertain_loads", uncertain_loads_json(problem)},
          {"structure", structure_json(truss)}};
}

}  // namespace kusabi::run
