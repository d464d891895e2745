// Checks of contact pairs and multi-point constraints, then of rollers and inclined supports.
#include "problems/structure/checks/constraint_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

#include <fmt/format.h>

namespace kusabi::problems {
namespace {

class ConstraintCheck {
 public:
  explicit ConstraintCheck(const Structure& structure) : structure_(structure) {
    for (std::size_t i = 0; i < structure.contact.size(); ++i) {
      if (structure.contact[i].against.empty()) continue;
      dependent_nodes_.push_back({structure.contact[i].node, &structure.contact[i].against,
                                  position_of(structure.sources.contact, static_cast<int>(i)),
                                  true});
    }
    for (std::size_t i = 0; i < structure.ties.size(); ++i) {
      dependent_nodes_.push_back({structure.ties[i].node, &structure.ties[i].to,
                                  position_of(structure.sources.ties, static_cast<int>(i)), false});
    }
  }

  void inclined() const;
  void dependent_nodes() const;
  void places() const;
  void ties() const;
  void rollers() const;

 private:
  /// A node that depends on a place of another body.
  struct DependentNode {
    int node;
    const std::vector<WeightedNode>* place;
    support::SourcePosition position;
    bool pair;  ///< a contact pair instead of a constraint; a node with several contact normals has
                ///< several
  };

  bool is_node(int node) const { return node >= 0 && node < std::ssize(structure_.node_names); }
  std::string name(int node) const { return quoted_name(structure_, node); }
  bool is_fixed(int node, int axis) const {
    return structure_.fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(axis)];
  }
  bool is_supported(int node) const {
    for (int axis = 0; axis < structure_.dimension; ++axis) {
      if (is_fixed(node, axis)) return true;
    }
    return false;
  }
  bool is_inclined(int node) const {
    return std::ranges::any_of(structure_.inclined,
                               [&](const auto& support) { return support.node == node; });
  }
  void place_of(const DependentNode& dependent, const std::set<int>& dependents) const;
  void supported_equally(const DependentNode& dependent) const;
  [[noreturn]] void fail(support::SourcePosition position, std::string_view message) const {
    throw structure_error(structure_, position, message);
  }

  const Structure& structure_;
  std::vector<DependentNode> dependent_nodes_;
};

void ConstraintCheck::inclined() const {
  std::set<int> seen;
  for (int index = 0; index < std::ssize(structure_.inclined); ++index) {
    const auto& [node, direction] = structure_.inclined[static_cast<std::size_t>(index)];
    const support::SourcePosition position = position_of(structure_.sources.inclined, index);
    if (!is_node(node)) {
      fail(position, fmt::format("inclined support {} names a node that does not exist", index));
    }
    if (direction.size() != structure_.dimension || !direction.allFinite() ||
        direction.isZero(0.0)) {
      fail(position, fmt::format("the direction of the inclined support of {} is not a direction; "
                                 "expected {} finite numbers that are not all zero",
                                 name(node), structure_.dimension));
    }
    if (is_supported(node) || !seen.insert(node).second) {
      fail(position, fmt::format("node {} is supported twice; expected once", name(node)));
    }
  }
}

void ConstraintCheck::dependent_nodes() const {
  std::set<int> dependents;
  for (const DependentNode& dependent : dependent_nodes_) {
    if (!is_node(dependent.node)) {
      fail(dependent.position, "a tie names a node that does not exist");
    }
    if (!dependents.insert(dependent.node).second && !dependent.pair) {
      fail(dependent.position,
           fmt::format("node {} is a dependent node twice; expected contact pairs only, or one tie",
                       name(dependent.node)));
    }
    if (is_inclined(dependent.node)) {
      fail(dependent.position,
           fmt::format("node {} is a dependent node and has an inclined support; expected one of "
                       "the two",
                       name(dependent.node)));
    }
  }
}

void ConstraintCheck::places() const {
  std::set<int> dependents;
  for (const DependentNode& dependent : dependent_nodes_) dependents.insert(dependent.node);
  for (const DependentNode& dependent : dependent_nodes_) place_of(dependent, dependents);
}

void ConstraintCheck::place_of(const DependentNode& dependent,
                               const std::set<int>& dependents) const {
  if (dependent.place->empty()) {
    fail(dependent.position,
         fmt::format("node {} is tied to no node; expected at least one", name(dependent.node)));
  }
  std::set<int> seen;
  for (const auto& [node, weight] : *dependent.place) {
    if (!is_node(node)) {
      fail(dependent.position,
           fmt::format("node {} is paired with a node that does not exist", name(dependent.node)));
    }
    if (node == dependent.node) {
      fail(dependent.position, fmt::format("node {} is paired with itself; expected a node of "
                                           "another body",
                                           name(node)));
    }
    if (dependents.contains(node)) {
      fail(dependent.position,
           fmt::format("node {} is paired with {}, which is itself a dependent node; expected "
                       "dependent nodes on one body and master nodes on the other",
                       name(dependent.node), name(node)));
    }
    if (!seen.insert(node).second) {
      fail(dependent.position, fmt::format("node {} is paired with {} twice; expected once",
                                           name(dependent.node), name(node)));
    }
    // The condition is false for NaN.
    if (!(std::abs(weight) >= smallest_share && std::abs(weight) <= largest_share)) {
      fail(dependent.position,
           fmt::format("the weight of {} at {} is {:g}; expected a size between {:g} and {:g}",
                       name(node), name(dependent.node), weight, smallest_share, largest_share));
    }
  }
  supported_equally(dependent);
}

void ConstraintCheck::supported_equally(const DependentNode& dependent) const {
  for (int axis = 0; axis < structure_.dimension; ++axis) {
    if (!is_fixed(dependent.node, axis)) continue;
    for (const auto& [node, weight] : *dependent.place) {
      if (is_fixed(node, axis)) continue;
      fail(dependent.position,
           fmt::format(
               "node {} is supported along {}, but {}, with which it is paired, is not; expected "
               "both or neither",
               name(dependent.node), axis_name(axis), name(node)));
    }
  }
}

void ConstraintCheck::ties() const {
  std::set<int> candidates;
  for (const ContactCandidate& candidate : structure_.contact) candidates.insert(candidate.node);
  for (int index = 0; index < std::ssize(structure_.ties); ++index) {
    const int node = structure_.ties[static_cast<std::size_t>(index)].node;
    const support::SourcePosition position = position_of(structure_.sources.ties, index);
    if (is_supported(node)) {
      fail(position, fmt::format("node {} is tied to others and supported; expected a support of "
                                 "those that it is tied to",
                                 name(node)));
    }
    if (candidates.contains(node)) {
      fail(position, fmt::format("node {} is tied to others and a contact candidate; expected one "
                                 "of the two",
                                 name(node)));
    }
  }
}

void ConstraintCheck::rollers() const {
  for (int index = 0; index < std::ssize(structure_.contact); ++index) {
    const ContactCandidate& candidate = structure_.contact[static_cast<std::size_t>(index)];
    if (is_inclined(candidate.node)) {
      fail(position_of(structure_.sources.contact, index),
           fmt::format("contact candidate {} has an inclined support; expected a roller along the "
                       "obstacle and along an axis, or none",
                       name(candidate.node)));
    }
    for (int axis = 0; axis < structure_.dimension; ++axis) {
      if (!is_fixed(candidate.node, axis) || candidate.normal(axis) == 0) continue;
      fail(
          position_of(structure_.sources.contact, index),
          fmt::format("contact candidate {} is supported along {}, across the obstacle; expected a "
                      "support along the obstacle, where the normal has no component, or none",
                      name(candidate.node), axis_name(axis)));
    }
  }
}

}  // namespace

void check_constraints(const Structure& structure) {
  const ConstraintCheck check(structure);
  check.inclined();
  check.dependent_nodes();
  check.ties();
  check.places();
  check.rollers();
}

}  // namespace kusabi::problems
