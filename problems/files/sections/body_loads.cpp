// Keys `gravity` and `temperature` of the file, and displaced supports: forces on the nodes.
#include <algorithm>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "problems/files/sections/problem_sections.hpp"
#include "problems/structure/assembly/body_forces.hpp"
#include "problems/structure/checks/element_check.hpp"

namespace kusabi::problems {
namespace {

// True if a property of some element or member is not zero.
template <class Part>
bool has_some(const std::vector<Part>& parts, double Part::*property) {
  return std::ranges::any_of(parts, [&](const Part& part) { return part.*property != 0; });
}

void add_weight(ProblemDraft& draft, const toml::node& entry) {
  Structure& structure = draft.structure();
  const auto forces =
      weight(structure, draft.reader().vector(entry, "gravity", structure.dimension));
  if (!has_some(structure.elements, &Element::density) &&
      !has_some(structure.members, &Member::mass))
    draft.reader().fail(entry, "gravity has no effect; expected the density of a material");
  if (!structure.superelements.empty()) {
    structure.warnings.emplace_back(
        structure_error(structure, draft.reader().position(entry),
                        "bodies of [[stiffness]] have no weight, since their mass is not known")
            .what());
  }
  const auto without = std::ranges::count(structure.elements, 0.0, &Element::density) +
                       std::ranges::count(structure.members, 0.0, &Member::mass);
  if (without > 0) {
    structure.warnings.emplace_back(
        structure_error(structure, draft.reader().position(entry),
                        fmt::format("{} elements and members have no density, and therefore no "
                                    "weight",
                                    without))
            .what());
  }
  for (int node = 0; node < draft.node_count(); ++node) {
    if (forces.col(node).isZero(0)) continue;
    structure.loads.push_back({Load::Kind::dead, node, forces.col(node)});
    structure.sources.loads.push_back(draft.reader().position(entry));
  }
}

void add_temperature(ProblemDraft& draft, const toml::node& entry) {
  Structure& structure = draft.structure();
  if (!structure.superelements.empty()) {
    draft.reader().fail(entry,
                        "temperature beside [[stiffness]], of which the expansion is not "
                        "known; expected elements and members only");
  }
  const auto forces = forces_of_temperature(structure, draft.reader().number(entry, "temperature"));
  if (!has_some(structure.elements, &Element::expansion) &&
      !has_some(structure.members, &Member::expansion))
    draft.reader().fail(entry, "temperature has no effect; expected the expansion of a material");
  structure.imposed_forces += forces;
}

// The displacement of a support that other displacements depend on is refused.
void refuse_dependent(const ProblemDraft& draft, const std::vector<WeightedNode>& shares,
                      const std::map<int, Eigen::VectorXd>& displaced) {
  const auto found = std::ranges::find_if(
      shares, [&](const WeightedNode& share) { return displaced.contains(share.node); });
  if (found == shares.end()) return;
  draft.reader().fail(
      support::SourcePosition{},
      fmt::format("the displaced support {} belongs to a place to which other nodes are tied; "
                  "expected a displacement of other nodes",
                  draft.node_name(found->node)));
}

void add_displaced(ProblemDraft& draft) {
  Structure& structure = draft.structure();
  const auto& displaced = draft.displaced();
  for (const MultiPointConstraint& tie : structure.ties) refuse_dependent(draft, tie.to, displaced);
  for (const Superelement& each : structure.superelements) {
    for (const auto& row : each.rows) refuse_dependent(draft, {{row.node, 1}}, displaced);
  }
  structure.imposed_forces += forces_of_displaced(structure, displaced);
  for (ContactCandidate& candidate : structure.contact) {
    const auto add = [&](int node, double share) {
      const auto found = displaced.find(node);
      if (found != displaced.end())
        candidate.clearance += share * candidate.normal.dot(found->second);
    };
    add(candidate.node, 1);
    for (const WeightedNode& share : candidate.against) add(share.node, -share.weight);
  }
}

}  // namespace

void read_body_loads(ProblemDraft& draft) {
  const auto* gravity = draft.section("gravity");
  const auto* temperature = draft.section("temperature");
  Structure& structure = draft.structure();
  if (gravity == nullptr && temperature == nullptr && draft.displaced().empty()) return;
  structure.coordinates.conservativeResize(Eigen::NoChange, draft.node_count());
  check_elements(structure);
  structure.imposed_forces =
      Eigen::MatrixXd::Zero(structure.dimension, structure.coordinates.cols());
  if (gravity != nullptr) add_weight(draft, *gravity);
  if (temperature != nullptr) add_temperature(draft, *temperature);
  if (!draft.displaced().empty()) add_displaced(draft);
  if (structure.imposed_forces.isZero(0)) structure.imposed_forces.resize(0, 0);
}

}  // namespace kusabi::problems
