// Rigid-body modes of each body, by elimination of its supports, springs and constraints: levers
// are exact differences of coordinates.
#include "verify/structure/unconstrained_bodies.hpp"

#include <algorithm>
#include <utility>

#include "verify/arithmetic/disjoint_sets.hpp"
#include "verify/structure/placed_nodes.hpp"

namespace kusabi::verify {
namespace {

// A connected component: its own nodes, and the ground nodes that touch it.
struct Body {
  std::vector<std::size_t> nodes;
  std::vector<std::size_t> ground;
  bool has_given_stiffness = false;  // depends on a stiffness of another program
};

bool is_ground(const Structure& structure, std::size_t node) {
  const auto& fixed = structure.fixed[node];
  return std::all_of(fixed.begin(),
                     fixed.begin() + static_cast<std::ptrdiff_t>(structure.dimension),
                     [](bool axis) { return axis; });
}

std::vector<Body> bodies_of(const Structure& structure) {
  std::vector<std::vector<std::size_t>> links;
  for (const auto& bar : structure.bars) links.push_back({bar.first, bar.second});
  for (const auto& element : structure.elements)
    links.emplace_back(element.nodes.begin(), element.nodes.end());
  for (const auto& stiffness : structure.given) {
    auto& nodes = links.emplace_back();
    for (const auto& row : stiffness.rows) {
      if (row.node) nodes.push_back(*row.node);
    }
  }
  for (const auto& tie : structure.ties) {  // ground nodes support the node, not the body
    links.push_back({tie.node});
    for (const auto& part : tie.to) {
      if (!is_ground(structure, part.node)) links.back().push_back(part.node);
    }
  }
  DisjointSets sets(structure.coordinates.size());
  const auto own = [&](const std::vector<std::size_t>& nodes) {
    return std::find_if(nodes.begin(), nodes.end(),
                        [&](auto node) { return !is_ground(structure, node); });
  };
  for (const auto& nodes : links) {
    const auto first = own(nodes);
    for (const auto node : nodes) {
      if (first != nodes.end() && !is_ground(structure, node)) sets.join(node, *first);
    }
  }
  std::map<std::size_t, std::size_t> number;  // body of each set
  std::vector<Body> bodies;
  for (std::size_t node = 0; node < structure.coordinates.size(); ++node) {
    if (is_ground(structure, node)) continue;
    const auto [place, is_new] = number.emplace(sets.of(node), bodies.size());
    if (is_new) bodies.emplace_back();
    bodies[place->second].nodes.push_back(node);
  }
  for (const auto& nodes : links) {
    const auto first = own(nodes);
    if (first == nodes.end()) continue;
    for (const auto node : nodes) {
      if (is_ground(structure, node)) bodies[number[sets.of(*first)]].ground.push_back(node);
    }
  }
  for (const auto& stiffness : structure.given) {
    for (const auto& row : stiffness.rows) {
      if (row.node && !is_ground(structure, *row.node))
        bodies[number[sets.of(*row.node)]].has_given_stiffness = true;
    }
  }
  return bodies;
}

// Displacement of a place along one axis by a rigid-body mode, given by the velocity of the centre
// and the angular velocity.
Rationals lever(const Vector& centre, const Rationals& place, std::size_t axis) {
  const auto d = place.size();
  std::vector<mpq_class> arm;
  for (std::size_t k = 0; k < d; ++k) arm.emplace_back(place[k] - mpq_class(centre[k]));
  Rationals row(d == 2 ? 3 : 6);
  row[axis] = 1;
  if (d == 2) {
    row[2] = axis == 0 ? mpq_class(-arm[1]) : arm[0];
  } else {  // (w x a)_axis = w_next a_last - w_last a_next
    const auto next = (axis + 1) % 3;
    const auto last = (axis + 2) % 3;
    row[3 + next] = arm[last];
    row[3 + last] = -arm[next];
  }
  return row;
}

Rationals lever(const Structure& structure, const Vector& centre, std::size_t node,
                std::size_t axis) {
  Rationals place;
  for (std::size_t k = 0; k < structure.dimension; ++k)
    place.emplace_back(structure.coordinates[node][k]);
  return lever(centre, place, axis);
}

// Conditions of inclined supports and multi-point constraints on the rigid-body modes of a body.
void demand_conditions(const Structure& structure, const Body& body, const Vector& centre,
                       Elimination& free) {
  const auto d = structure.dimension;
  const auto is_own = [&](std::size_t node) {
    return std::binary_search(body.nodes.begin(), body.nodes.end(), node);
  };
  const auto add = [&](Rationals& row, const mpq_class& weight, std::size_t node,
                       std::size_t axis) {
    const auto own = lever(structure, centre, node, axis);
    row.resize(own.size());
    for (std::size_t k = 0; k < own.size(); ++k) row[k] += weight * own[k];
  };
  for (const auto& [node, direction] : structure.inclined) {
    if (!is_own(node)) continue;
    Rationals row;
    for (std::size_t axis = 0; axis < d; ++axis) add(row, mpq_class(direction[axis]), node, axis);
    free.add_equation(row);
  }
  for (const auto& tie : structure.ties) {
    for (std::size_t axis = 0; axis < d && is_own(tie.node); ++axis) {
      Rationals row;
      add(row, 1, tie.node, axis);
      for (const auto& [node, weight] : tie.to) {
        if (!is_ground(structure, node)) add(row, mpq_class(-weight), node, axis);
      }
      free.add_equation(row);
    }
  }
}

// Rigid-body modes of a body that displace at least one of its nodes.
std::vector<Rationals> motions_of(const Structure& structure, const Body& body,
                                  const Vector& centre) {
  const auto d = structure.dimension;
  Elimination free(d == 2 ? 3 : 6);
  for (const auto* nodes : {&body.nodes, &body.ground}) {
    for (const auto node : *nodes) {
      for (std::size_t axis = 0; axis < d && !free.basis().empty(); ++axis) {
        if (structure.fixed[node][axis]) free.add_equation(lever(structure, centre, node, axis));
      }
    }
  }
  for (const auto& spring : structure.springs) {
    if (free.basis().empty()) break;
    if (std::binary_search(body.nodes.begin(), body.nodes.end(), spring.node))
      free.add_equation(lever(structure, centre, spring.node, spring.axis));
  }
  demand_conditions(structure, body, centre, free);
  Elimination moving(free.basis());
  for (const auto node : body.nodes) {
    for (std::size_t axis = 0; axis < d && !moving.basis().empty(); ++axis)
      moving.add_equation(lever(structure, centre, node, axis));
  }
  return moving.removed();
}

}  // namespace

UnconstrainedBodies::UnconstrainedBodies(const Structure& structure)
    : structure_(structure),
      size_(structure.dimension == 2 ? 3 : 6),
      placed_(placed_nodes(structure)) {
  for (const auto& body : bodies_of(structure)) {
    // Stiffness matrices of other programs have rigid-body modes only up to rounding. K must
    // therefore be definite for such a body, which is proved with the rest.
    if (body.has_given_stiffness) continue;
    const auto centre = structure.coordinates[body.nodes.front()];
    const auto own = motions_of(structure, body, centre);
    if (own.empty()) continue;
    for (const auto node : body.nodes) body_of_[node] = bodies_.size();
    const std::size_t first = size_ * bodies_.size();
    bodies_.push_back({centre, first});
    for (const auto& motion : own) {
      auto& all = motions_.emplace_back(first);
      all.insert(all.end(), motion.begin(), motion.end());
    }
  }
  for (auto& motion : motions_) motion.resize(size_ * bodies_.size());
}

Rationals UnconstrainedBodies::at(std::size_t node, std::size_t axis) const {
  Rationals row(size_ * bodies_.size());
  const auto found = body_of_.find(node);
  if (found == body_of_.end()) return row;
  const auto& [centre, first] = bodies_[found->second];
  const auto moved = placed_.find(node);
  const auto own = moved == placed_.end() ? lever(structure_, centre, node, axis)
                                          : lever(centre, moved->second, axis);
  std::copy(own.begin(), own.end(), row.begin() + static_cast<std::ptrdiff_t>(first));
  return row;
}

Rationals UnconstrainedBodies::at(const ContactPoint& point, std::size_t axis) const {
  auto row = at(point.node, axis);
  for (const auto& [node, weight] : point.against) {
    const auto other = at(node, axis);
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (sgn(other[k]) != 0) row[k] -= mpq_class(weight) * other[k];
    }
  }
  return row;
}

std::vector<GroundSpring> UnconstrainedBodies::grounding_springs(Elimination unseen) const {
  std::vector<GroundSpring> springs;
  while (!unseen.basis().empty()) {
    GroundSpring best{};
    mpq_class maximum;
    for (const auto& [node, body] : body_of_) {
      for (std::size_t axis = 0; axis < structure_.dimension; ++axis) {
        if (structure_.fixed[node][axis]) continue;
        const mpq_class moves = abs(dot(at(node, axis), unseen.basis().front()));
        if (moves > maximum) {
          maximum = moves;
          best = {node, axis, 1};
        }
      }
    }
    unseen.add_equation(at(best.node, best.axis));
    springs.push_back(best);
  }
  return springs;
}

}  // namespace kusabi::verify
