// Counts and their sentences.
#include "run/show/structure_summary.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "problems/structure/bodies/connected_bodies.hpp"
#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/element_shape.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "run/show/contact_checks.hpp"
#include "run/show/expectation.hpp"

namespace kusabi::run {
namespace {

using problems::Structure;

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
