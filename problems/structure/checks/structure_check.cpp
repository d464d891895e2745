// Checks of sizes, members, nodes, springs, candidates and loads.
#include "problems/structure/checks/structure_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/assembly/contact_frame.hpp"
#include "problems/structure/checks/constraint_check.hpp"
#include "problems/structure/checks/element_check.hpp"
#include "problems/structure/checks/superelement_check.hpp"
#include "problems/structure/checks/uncertainty_check.hpp"
#include "problems/structure/geometry/surface.hpp"
#include "problems/structure/model/several_normals.hpp"
#include "problems/structure/model/superelement.hpp"

namespace kusabi::problems {
namespace {

/// Normals made by this library have unit length up to a few rounding errors.
constexpr double unit_length_tolerance = 1e-12;

/// The checks of one structure, by subject.
class StructureCheck {
 public:
  explicit StructureCheck(const Structure& structure) : structure_(structure) {}

  void sizes() const;
  void coordinates() const;
  void members() const;
  void every_node_has_stiffness() const;
  void springs() const;
  void contact_count() const;
  void contact_nodes() const;
  void contact_directions() const;
  void loads() const;

 private:
  int node_count() const { return static_cast<int>(structure_.node_names.size()); }
  bool is_node(int node) const { return node >= 0 && node < node_count(); }
  std::string name(int node) const { return quoted_name(structure_, node); }
  bool is_fixed(int node, int axis) const {
    return structure_.fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(axis)];
  }
  int fixed_axes(int node) const;
  void member(int index) const;
  void yield_forces(int index) const;
  [[noreturn]] void fail(support::SourcePosition position, std::string_view message) const {
    throw structure_error(structure_, position, message);
  }

  const Structure& structure_;
};

int StructureCheck::fixed_axes(int node) const {
  int count = 0;
  for (int axis = 0; axis < structure_.dimension; ++axis) count += is_fixed(node, axis) ? 1 : 0;
  return count;
}

void StructureCheck::sizes() const {
  if (structure_.dimension != 2 && structure_.dimension != 3) {
    fail({}, fmt::format("dimension is {}; expected 2 or 3", structure_.dimension));
  }
  if (node_count() == 0) fail({}, "no nodes; expected at least two");
  if (structure_.members.empty() && structure_.elements.empty() &&
      structure_.superelements.empty()) {
    fail({}, "no members; expected at least one");
  }
  if (structure_.coordinates.rows() != structure_.dimension ||
      structure_.coordinates.cols() != node_count()) {
    fail({}, fmt::format("coordinates are {} x {}; expected {} x {}", structure_.coordinates.rows(),
                         structure_.coordinates.cols(), structure_.dimension, node_count()));
  }
  if (structure_.fixed.size() != structure_.node_names.size()) {
    fail({}, fmt::format("supports are given for {} nodes; expected all {}",
                         structure_.fixed.size(), node_count()));
  }
}

void StructureCheck::coordinates() const {
  for (int node = 0; node < node_count(); ++node) {
    const auto position = structure_.coordinates.col(node);
    if (!position.allFinite() || position.cwiseAbs().maxCoeff() > largest_magnitude) {
      fail(position_of(structure_.sources.nodes, node),
           fmt::format("node {} has a coordinate out of range; expected at most {:g} in magnitude",
                       name(node), largest_magnitude));
    }
  }
}

void StructureCheck::member(int index) const {
  const auto& [first, second, axial_stiffness, yield, mass, expansion] =
      structure_.members[static_cast<std::size_t>(index)];
  const support::SourcePosition position = position_of(structure_.sources.members, index);
  if (!is_node(first) || !is_node(second)) {
    fail(position, fmt::format("member {} names a node that does not exist", index));
  }
  // The condition is false for NaN.
  if (axial_stiffness != 0 &&
      !(axial_stiffness >= smallest_magnitude && axial_stiffness <= largest_magnitude)) {
    fail(position_of(structure_.sources.axial_stiffnesses, index),
         axial_stiffness_fault(axial_stiffness));
  }
  if (yield) yield_forces(index);
  if (first == second) {
    fail(position,
         fmt::format("member from node {} to itself; expected two different nodes", name(first)));
  }
  const auto from = structure_.coordinates.col(first);
  const auto to = structure_.coordinates.col(second);
  const double size = std::max(from.cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff());
  const double length = (to - from).stableNorm();
  if (length <= zero_length * size || length < smallest_magnitude) {
    fail(position, fmt::format("member from {} to {} has zero length; expected two nodes at "
                               "different places",
                               name(first), name(second)));
  }
}

void StructureCheck::yield_forces(int index) const {
  const auto& yield = *structure_.members[static_cast<std::size_t>(index)].yield;
  const auto in_range = [](double force) {
    return force == 0 || (force >= smallest_magnitude && force <= largest_magnitude);
  };
  const support::SourcePosition position = position_of(structure_.sources.yields, index);
  for (const double force : {yield.tension, yield.compression}) {
    if (in_range(force)) continue;
    fail(position, fmt::format("a yield force is {:g}; expected a magnitude: 0, or between {:g} "
                               "and {:g}",
                               force, smallest_magnitude, largest_magnitude));
  }
  if (yield.tension == 0 && yield.compression == 0) {
    fail(position, "the yield force is 0; expected a positive one in tension or in compression");
  }
}

void StructureCheck::members() const {
  std::set<std::pair<int, int>> seen;
  for (int index = 0; index < static_cast<int>(structure_.members.size()); ++index) {
    member(index);
    const Member& bar = structure_.members[static_cast<std::size_t>(index)];
    if (!seen.insert(std::minmax(bar.first, bar.second)).second) {
      fail(position_of(structure_.sources.members, index),
           fmt::format("second member between {} and {}; expected each pair of nodes once",
                       name(bar.first), name(bar.second)));
    }
  }
}

void StructureCheck::every_node_has_stiffness() const {
  std::vector<bool> held(structure_.node_names.size(), false);
  for (const Member& bar : structure_.members) {
    held[static_cast<std::size_t>(bar.first)] = true;
    held[static_cast<std::size_t>(bar.second)] = true;
  }
  for (const Element& element : structure_.elements) {
    for (const int node : element.nodes) held[static_cast<std::size_t>(node)] = true;
  }
  for (const Superelement& each : structure_.superelements) {
    for (const int node : nodes_of(each)) held[static_cast<std::size_t>(node)] = true;
  }
  for (int index = 0; index < static_cast<int>(structure_.contact.size()); ++index) {
    const int node = structure_.contact[static_cast<std::size_t>(index)].node;
    if (structure_.outlines.empty() || !is_node(node) || held[static_cast<std::size_t>(node)])
      continue;
    fail(position_of(structure_.sources.contact, index),
         fmt::format(
             "contact candidate {} has no row in a [[stiffness]]; expected rows of it, since "
             "its body has no other stiffness",
             name(node)));
  }
  for (int node = 0; node < node_count(); ++node) {
    if (!held[static_cast<std::size_t>(node)] && fixed_axes(node) < structure_.dimension) {
      fail(position_of(structure_.sources.nodes, node),
           fmt::format("node {} has no member; expected a member to it, or no such node",
                       name(node)));
    }
  }
}

void StructureCheck::springs() const {
  for (int index = 0; index < static_cast<int>(structure_.springs.size()); ++index) {
    const auto& [node, axis, stiffness] = structure_.springs[static_cast<std::size_t>(index)];
    const support::SourcePosition position = position_of(structure_.sources.springs, index);
    if (!is_node(node)) {
      fail(position, fmt::format("spring {} names a node that does not exist", index));
    }
    if (axis < 0 || axis >= structure_.dimension) {
      fail(position, fmt::format("spring {} is along an axis that does not exist", index));
    }
    if (is_fixed(node, axis)) {
      fail(position, fmt::format("a spring at {} along {}, where it is also supported; expected a "
                                 "spring where the node is free",
                                 name(node), axis_name(axis)));
    }
    // The condition is false for NaN.
    if (!(stiffness >= smallest_magnitude && stiffness <= largest_magnitude)) {
      fail(position,
           fmt::format("the stiffness of a spring is {:g}; expected a positive one between "
                       "{:g} and {:g}",
                       stiffness, smallest_magnitude, largest_magnitude));
    }
  }
}

void StructureCheck::contact_count() const {
  if (structure_.contact.size() <= static_cast<std::size_t>(max_contact_candidates)) return;
  fail(position_of(structure_.sources.contact, max_contact_candidates),
       fmt::format("{} contact candidates; expected at most {}, since K and F are full matrices",
                   structure_.contact.size(), max_contact_candidates));
}

void StructureCheck::contact_nodes() const {
  for (int index = 0; index < static_cast<int>(structure_.contact.size()); ++index) {
    const int node = structure_.contact[static_cast<std::size_t>(index)].node;
    const support::SourcePosition position = position_of(structure_.sources.contact, index);
    if (!is_node(node)) {
      fail(position, fmt::format("contact candidate {} names a node that does not exist", index));
    }
    if (fixed_axes(node) == structure_.dimension) {
      fail(position, fmt::format("contact candidate {} is also supported along every axis; "
                                 "expected a node that can move",
                                 name(node)));
    }
  }
}

void StructureCheck::contact_directions() const {
  for (int index = 0; index < static_cast<int>(structure_.contact.size()); ++index) {
    const ContactCandidate& candidate = structure_.contact[static_cast<std::size_t>(index)];
    const auto& [node, normal, tangent, friction] =
        std::tie(candidate.node, candidate.normal, candidate.tangent, candidate.friction);
    // The condition is false for NaN.
    if (friction != 0 && !(friction >= smallest_friction && friction <= largest_friction)) {
      fail(position_of(structure_.sources.frictions, index),
           fmt::format("the friction factor is {:g}; expected 0, or a number between {:g} and {:g}",
                       friction, smallest_friction, largest_friction));
    }
    if (normal.size() != structure_.dimension ||
        !(std::abs(normal.norm() - 1.0) <= unit_length_tolerance)) {
      fail(position_of(structure_.sources.normals, index),
           fmt::format("the normal at {} is not a unit vector; expected {} components of norm 1",
                       name(node), structure_.dimension));
    }
    if (!tangent) continue;
    const support::SourcePosition position = position_of(structure_.sources.tangents, index);
    if (tangent->size() != structure_.dimension || !tangent->allFinite()) {
      fail(position, fmt::format("the tangent at {} is not a vector of {} finite numbers",
                                 name(node), structure_.dimension));
    }
    // The condition is false for a zero tangent.
    if (!(tangent_sine(normal, *tangent) > smallest_tangent_sine)) {
      fail(position, fmt::format("the tangent at {} is zero or parallel to the normal; expected a "
                                 "vector that points along the surface",
                                 name(node)));
    }
  }
}

void StructureCheck::loads() const {
  for (int index = 0; index < static_cast<int>(structure_.loads.size()); ++index) {
    const Load& load = structure_.loads[static_cast<std::size_t>(index)];
    const support::SourcePosition position = position_of(structure_.sources.loads, index);
    if (!is_node(load.node)) {
      fail(position, fmt::format("load {} names a node that does not exist", index));
    }
    if (load.force.size() != structure_.dimension || !load.force.allFinite() ||
        load.force.cwiseAbs().maxCoeff() > largest_magnitude) {
      fail(position, fmt::format("the load at {} is not a vector of {} numbers of at most {:g}",
                                 name(load.node), structure_.dimension, largest_magnitude));
    }
  }
}

}  // namespace

std::string axial_stiffness_fault(double value) {
  return fmt::format("EA is {:g}; expected a positive axial stiffness between {:g} and {:g}", value,
                     smallest_magnitude, largest_magnitude);
}

void check_structure(const Structure& structure) {
  const StructureCheck check(structure);
  check.sizes();
  check.coordinates();
  check.members();
  check_elements(structure);
  check_superelements(structure);
  check.every_node_has_stiffness();
  check.springs();
  check.contact_count();
  check.contact_nodes();
  check.contact_directions();
  check_several_normals(structure);
  check_constraints(structure);
  check_normals(structure);
  check.loads();
  check_uncertainty(structure);
}

}  // namespace kusabi::problems
