// Counts and their sentences, checks of the geometry of contact, and expected times.
#include "run/show/structure_summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "problems/structure/bodies/connected_bodies.hpp"
#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/element_shape.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::run {
namespace {

struct Cost {
  std::size_t candidates;  ///< up to so many
  const char* bracket;     ///< a proved bracket of kusabi critical
  const char* list;        ///< the list of all patterns
};

constexpr std::array in_the_plane{
    Cost{30, "in about a second", "in about a second"},
    Cost{60, "in seconds", "in seconds to a minute"},
    Cost{200, "in seconds to minutes", "may not end (kusabi patterns --exists finds one pattern)"},
};
constexpr std::array in_space{
    Cost{30, "in about a second", "in about a second"},
    Cost{64, "in seconds", "in seconds to minutes"},
    Cost{150, "in seconds to a minute", "in minutes, or it may not end"},
    Cost{250, "in about a minute", "may not end"},
};

const Cost* cost_of(std::span<const Cost> costs, std::size_t candidates) {
  for (const auto& cost : costs) {
    if (candidates <= cost.candidates) return &cost;
  }
  return nullptr;
}

// The least n for which `every = n` leaves at most 60 candidates.
std::size_t thinning(std::size_t candidates) {
  constexpr std::size_t comfortable = 60;
  return (candidates + comfortable - 1) / comfortable;
}

// A sentence on `critical` and one on the list of all patterns; empty without candidates.
// @param dimension 2 or 3
std::string expectation(int dimension, std::size_t candidates) {
  if (candidates == 0) return {};
  const auto* const cost =
      dimension == 2 ? cost_of(in_the_plane, candidates) : cost_of(in_space, candidates);
  auto text = cost == nullptr
                  ? std::string(
                        "the bracket (critical) takes minutes or more; the list of "
                        "all patterns may not end")
                  : fmt::format("the bracket (critical) {}; the list of all patterns {}",
                                cost->bracket, cost->list);
  if (const auto every = thinning(candidates); every > 1) {
    text += fmt::format("; every = {} in [[contact]] leaves about {} candidates", every,
                        candidates / every);
  }
  return text;
}

using problems::ContactCandidate;
using problems::Structure;

using Candidates = std::vector<const ContactCandidate*>;

/// Distances below this, relative to the size of the structure, are rounding of a file.
constexpr double rounding = 1e-6;

double size_of(const Structure& structure) {
  return (structure.coordinates.rowwise().maxCoeff() - structure.coordinates.rowwise().minCoeff())
      .norm();
}

std::string within(const Structure& structure, double distance) {
  if (distance <= rounding * size_of(structure)) return "";
  return fmt::format(", but the nodes are up to {:.3g} {} apart along it", distance,
                     structure.units.length);
}

// One normal: a plane, or a straight side in the plane, and the distance of its nodes.
std::string flat_shape(const Structure& structure, const Candidates& candidates) {
  const auto& normal = candidates.front()->normal;
  double minimum = HUGE_VAL;
  double maximum = -HUGE_VAL;
  for (const auto* const each : candidates) {
    const double place = normal.dot(structure.coordinates.col(each->node));
    minimum = std::min(minimum, place);
    maximum = std::max(maximum, place);
  }
  return fmt::format("one normal ({:.4g}){}", fmt::join((normal.array() + 0.0).eval(), ", "),
                     within(structure, maximum - minimum));
}

// Normals at one angle to an axis: a cylinder (90 degrees) or a cone. Empty: neither.
std::string round_shape(const Structure& structure, const Candidates& candidates) {
  constexpr double alike = 1e-6;
  if (structure.dimension == 2 || candidates.size() < 4) return "";
  Eigen::Matrix3Xd normals(3, static_cast<Eigen::Index>(candidates.size()));
  for (Eigen::Index i = 0; i < normals.cols(); ++i)
    normals.col(i) = candidates[static_cast<std::size_t>(i)]->normal;
  // The axis is perpendicular to all differences of normals.
  const Eigen::Matrix3Xd differences = normals.colwise() - normals.rowwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(differences *
                                                              differences.transpose());
  if (!(spread.eigenvalues()(0) <= alike * alike * static_cast<double>(normals.cols())) ||
      !(spread.eigenvalues()(1) > alike))
    return "";
  const Eigen::Vector3d axis = spread.eigenvectors().col(0);
  const double angle =
      std::asin(std::min(1.0, std::abs(axis.dot(normals.col(0))))) * 180 / std::numbers::pi;
  const auto along =
      fmt::format("about an axis ({:.4g})", fmt::join((axis.array() + 0.0).eval(), ", "));
  if (angle < alike * 180) return "normals of a cylinder " + along;
  return fmt::format("normals of a cone of half angle {:.6g}° {}", angle, along);
}

std::string shape_of(const Structure& structure, const Candidates& candidates) {
  constexpr double alike = 1e-9;
  const auto& first = candidates.front()->normal;
  const bool flat = std::ranges::all_of(
      candidates, [&](const auto* each) { return (each->normal - first).norm() <= alike; });
  if (flat) return flat_shape(structure, candidates);
  auto round = round_shape(structure, candidates);
  return round.empty() ? "normals in several directions" : round;
}

// Number of the body of a node, from 1; 0: it is the ground.
int body_of(const std::vector<std::set<int>>& bodies, int node) {
  const auto own =
      std::ranges::find_if(bodies, [&](const auto& nodes) { return nodes.contains(node); });
  return own == bodies.end() ? 0 : static_cast<int>(own - bodies.begin()) + 1;
}

std::string named(int body) {
  return body == 0 ? "the ground" : fmt::format("body {}", body);
}

// One line for each surface of candidates: its name, the bodies that touch, the number of
// candidates, the shape of which their normals are, and their distance from it.
std::vector<std::string> touching_surfaces(const Structure& structure) {
  const auto bodies = problems::connected_bodies(structure);
  std::map<std::pair<std::string, std::string>, Candidates> surfaces;
  for (const auto& each : structure.contact) {
    const auto own = named(body_of(bodies, each.node));
    const auto other = each.against.empty() ? std::string("an obstacle")
                                            : named(body_of(bodies, each.against.front().node));
    surfaces[{each.surface, own + " against " + other}].push_back(&each);
  }
  std::vector<std::string> lines;
  for (const auto& [key, candidates] : surfaces) {
    const auto& [name, touch] = key;
    lines.push_back(fmt::format("{}{}: {}, {}", name.empty() ? "" : name + ", ", touch,
                                answer::counted(candidates.size(), "candidate"),
                                shape_of(structure, candidates)));
  }
  return lines;
}

// Nodes of different parts at one place without connection, in words.
std::string coincident_nodes(const Structure& structure) {
  return problems::coincidence_warnings(structure).empty()
             ? "none that are not joined"
             : "nodes that are not joined, see the warnings";
}

std::string joined(const std::vector<std::string>& parts) {
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

void add_counted(std::vector<std::string>& parts, std::size_t count, std::string_view thing) {
  if (count > 0) parts.push_back(answer::counted(count, thing));
}

std::string bodies(const Structure& structure) {
  std::vector<std::string> parts;
  add_counted(parts, structure.node_names.size(), "node");
  add_counted(parts, structure.members.size(), "member");
  std::map<problems::ElementShape, std::size_t> shapes;
  for (const auto& element : structure.elements) ++shapes[element.shape];
  for (const auto& [shape, count] : shapes)
    add_counted(parts, count, problems::shape_traits(shape).name);
  if (!structure.superelements.empty()) {
    parts.push_back(answer::counted(structure.superelements.size(), "stiffness") + " from a file");
  }
  return joined(parts);
}

// Connected bodies with their supports.
std::string connected(const problems::CheckedStructure& structure) {
  constexpr std::size_t maximum = 12;
  const auto all = problems::connected_bodies(structure);
  const auto& unconstrained = structure.unconstrained_bodies();
  const auto held = [&](const std::set<int>& nodes) {
    const auto own = std::ranges::find_if(
        unconstrained, [&](const auto& body) { return nodes.contains(body.nodes.front()); });
    if (own != unconstrained.end()) return "unconstrained, " + described(*own);
    const bool is_given = std::ranges::any_of(structure->superelements, [&](const auto& each) {
      return std::ranges::any_of(each.rows,
                                 [&](const auto& row) { return nodes.contains(row.node); });
    });
    return std::string(is_given ? "constrained as given by its stiffness from a file"
                                : "constrained");
  };
  if (all.empty()) return "";
  if (all.size() == 1) return fmt::format("  bodies      one, {}\n", held(all.front()));
  auto text = fmt::format("  bodies      {}, not connected with each other\n", all.size());
  for (const auto& nodes : std::span(all).first(std::min(all.size(), maximum))) {
    const auto& first = structure->node_names[static_cast<std::size_t>(*nodes.begin())];
    text +=
        fmt::format("              {}, the first {}, {}\n", answer::counted(nodes.size(), "node"),
                    support::in_quotes(first), held(nodes));
  }
  if (all.size() > maximum)
    text += fmt::format("              and {} more\n", all.size() - maximum);
  return text;
}

std::string extent(const Structure& structure) {
  std::vector<std::string> parts;
  parts.reserve(static_cast<std::size_t>(structure.dimension));
  for (int axis = 0; axis < structure.dimension; ++axis) {
    parts.push_back(fmt::format("{} {:.6g} to {:.6g}", problems::axis_name(axis),
                                structure.coordinates.row(axis).minCoeff(),
                                structure.coordinates.row(axis).maxCoeff()));
  }
  return fmt::format("{}, in {}", joined(parts), structure.units.length);
}

// Numbers of supported nodes by axes.
std::string supports(const Structure& structure) {
  std::map<std::string, std::size_t> held;
  for (const auto& axes : structure.fixed) {
    std::vector<std::string_view> names;
    for (int axis = 0; axis < structure.dimension; ++axis) {
      if (axes[static_cast<std::size_t>(axis)]) names.push_back(problems::axis_name(axis));
    }
    if (!names.empty()) ++held[fmt::format("{}", fmt::join(names, " "))];
  }
  std::vector<std::string> parts;
  parts.reserve(held.size());
  for (const auto& [axes, count] : held)
    parts.push_back(fmt::format("{} along {}", answer::counted(count, "node"), axes));
  add_counted(parts, structure.inclined.size(), "inclined support");
  add_counted(parts, structure.springs.size(), "spring");
  add_counted(parts, structure.ties.size(), "multi-point constraint");
  return joined(parts);
}

std::string candidates(const Structure& structure) {
  if (structure.contact.empty()) return "none";
  const auto bodies = std::ranges::count_if(structure.contact,
                                            [](const auto& each) { return !each.against.empty(); });
  const auto [minimum, maximum] =
      std::ranges::minmax(structure.contact, {}, &problems::ContactCandidate::friction);
  auto text = fmt::format("{}", structure.contact.size());
  if (bodies > 0) text += fmt::format(", {} of them against another body", bodies);
  if (minimum.friction != maximum.friction) {
    return text + fmt::format("; friction {:g} to {:g} times the coefficient", minimum.friction,
                              maximum.friction);
  }
  if (maximum.friction != 1)
    text += fmt::format("; friction {:g} times the coefficient", maximum.friction);
  return text;
}

// Surfaces of the candidates, a line each.
std::string touching(const Structure& structure) {
  constexpr std::size_t maximum = 12;
  const auto lines = touching_surfaces(structure);
  std::string text;
  for (const auto& line : std::span(lines).first(std::min(lines.size(), maximum)))
    text += fmt::format("              {}\n", line);
  if (lines.size() > maximum)
    text += fmt::format("              and {} more\n", lines.size() - maximum);
  return text;
}

std::string expected(const Structure& structure) {
  const auto text = expectation(structure.dimension, structure.contact.size());
  return text.empty() ? text : fmt::format("  expect      {}\n", text);
}

std::string loads(const Structure& structure) {
  std::vector<std::string> parts;
  for (const auto& [kind, name] : {std::pair{problems::Load::Kind::dead, "dead load"},
                                   std::pair{problems::Load::Kind::reference, "reference load"}}) {
    const auto count = std::ranges::count(structure.loads, kind, &problems::Load::kind);
    add_counted(parts, static_cast<std::size_t>(count), name);
  }
  if (structure.uncertain) {
    parts.push_back(fmt::format("{} uncertain", structure.uncertain->size()));
  } else if (!parts.empty()) {
    parts.emplace_back("components without one of these are uncertain");
  }
  const auto cases = problems::load_cases(structure);
  if (!cases.empty()) {
    parts.push_back(fmt::format("in {}: {}", answer::counted(cases.size(), "load case"),
                                problems::choice_of_load_cases(structure)));
  }
  return joined(parts);
}

}  // namespace

std::string structure_summary(const problems::CheckedStructure& structure) {
  return fmt::format(
      "{}: {}\n  consists of {}\n{}  extent      {}\n  coincident  {}\n  supports    {}\n"
      "  candidates  {}\n{}  loads       {}\n{}",
      structure->name, structure->dimension == 2 ? "in the plane" : "in space", bodies(structure),
      connected(structure), extent(structure), coincident_nodes(structure), supports(structure),
      candidates(structure), touching(structure), loads(structure), expected(structure));
}

}  // namespace kusabi::run
