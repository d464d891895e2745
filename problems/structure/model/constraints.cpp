// Master degrees of freedom: first of inclined supports, then of nodes that depend on other nodes,
// which may have inclined supports.
#include "problems/structure/model/constraints.hpp"

#include <cmath>
#include <cstddef>
#include <span>

namespace kusabi::problems {
namespace {

using numbers::Precise;

/// Weights of the free displacements in one displacement.
class MasterDegrees {
 public:
  MasterDegrees(const Structure& structure, FreeDegrees& degrees)
      : structure_(structure), degrees_(degrees) {
    degrees_.master_degrees.resize(static_cast<std::size_t>(degrees_.number.size()));
  }

  void incline(const InclinedSupport& support) {
    const int held = largest_component_axis(support.direction);
    for (int axis = 0; axis < structure_.dimension; ++axis) {
      const double component = support.direction(axis);
      if (axis == held || component == 0) continue;
      at(held, support.node)
          .push_back({degrees_.number(axis, support.node),
                      -Precise(component) / Precise(support.direction(held))});
    }
  }

  /// Adds the displacement of a place of another body to that of the node.
  void follow(int node, std::span<const WeightedNode> place) {
    for (int axis = 0; axis < structure_.dimension; ++axis) {
      // Both the place and the node are fixed along this axis (check_constraints).
      if (structure_.fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(axis)])
        continue;
      for (const auto& [master, weight] : place) {
        const int number = degrees_.number(axis, master);
        if (number >= 0) at(axis, node).push_back({number, Precise(weight)});
        for (const auto& [farther, share] : at(axis, master))
          at(axis, node).push_back({farther, Precise(weight) * share});
      }
    }
  }

 private:
  std::vector<MasterDegree>& at(int axis, int node) {
    return degrees_.master_degrees[static_cast<std::size_t>(degrees_.number.rows() * node + axis)];
  }

  const Structure& structure_;
  FreeDegrees& degrees_;
};

}  // namespace

int largest_component_axis(const Eigen::VectorXd& direction) {
  int steepest = 0;
  for (int axis = 1; axis < static_cast<int>(direction.size()); ++axis) {
    if (std::abs(direction(axis)) > std::abs(direction(steepest))) steepest = axis;
  }
  return steepest;
}

bool has_constraints(const Structure& structure) {
  if (!structure.inclined.empty() || !structure.ties.empty()) return true;
  for (const ContactCandidate& candidate : structure.contact) {
    if (!candidate.against.empty()) return true;
  }
  return false;
}

std::set<std::pair<int, int>> dependent_displacements(const Structure& structure) {
  std::set<std::pair<int, int>> made;
  for (const InclinedSupport& support : structure.inclined)
    made.emplace(support.node, largest_component_axis(support.direction));
  for (const MultiPointConstraint& tie : structure.ties) {
    for (int axis = 0; axis < structure.dimension; ++axis) made.emplace(tie.node, axis);
  }
  return made;
}

void set_master_degrees(const Structure& structure, FreeDegrees& degrees) {
  if (!has_constraints(structure)) return;
  MasterDegrees master_degrees(structure, degrees);
  for (const InclinedSupport& support : structure.inclined) master_degrees.incline(support);
  for (const MultiPointConstraint& tie : structure.ties) master_degrees.follow(tie.node, tie.to);
  for (const ContactCandidate& candidate : structure.contact) {
    // A node with several contact normals may be opposite to two places, so it keeps displacements
    // of its own.
    if (!degrees.several_normals.contains(candidate.node))
      master_degrees.follow(candidate.node, candidate.against);
  }
}

}  // namespace kusabi::problems
