// Rigid-body modes of each body in rational numbers: levers are differences of coordinates; only
// the division of directions by their lengths is irrational.
#include "verify/structure/contact_motions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "verify/arithmetic/disjoint_sets.hpp"
#include "verify/arithmetic/enclosure.hpp"
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

// Rigid-body modes of all unconstrained bodies, side by side.
class UnconstrainedBodies {
 public:
  explicit UnconstrainedBodies(const Structure& structure);

  [[nodiscard]] const std::vector<Rationals>& motions() const { return motions_; }

  /// Displacements of a node along an axis.
  [[nodiscard]] Rationals at(std::size_t node, std::size_t axis) const;

  /// Displacements of a candidate along an axis, relative to the opposite place.
  [[nodiscard]] Rationals at(const ContactPoint& point, std::size_t axis) const;

  /// Grounding springs for modes that displace no candidate, each where the first remaining mode is
  /// largest.
  [[nodiscard]] std::vector<GroundSpring> grounding_springs(Elimination unseen) const;

 private:
  struct Placed {
    Vector centre;
    std::size_t first;  // of its modes among all
  };

  const Structure& structure_;
  std::size_t size_;  // number of parameters of a rigid-body mode
  std::vector<Placed> bodies_;
  std::map<std::size_t, std::size_t> body_of_;  // by node
  std::map<std::size_t, Rationals> placed_;  // exact places of displaced nodes (placed_nodes.hpp)
  std::vector<Rationals> motions_;
};

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

// The directions n, t1[, t2] before normalisation, and their lengths.
struct Directions {
  std::vector<Rationals> vectors;
  std::vector<Enclosure> lengths;
};

template <class Number>
std::vector<std::vector<Number>> directions(const ContactPoint& point, std::size_t d) {
  using Components = std::vector<Number>;
  Components n;
  Vector axis{};
  axis[point.tangent_axis] = 1;
  const Vector wish = point.tangent.value_or(axis);
  Number square(0.0);
  Number along(0.0);
  for (std::size_t k = 0; k < d; ++k) {
    n.emplace_back(point.normal[k]);
    square = Number(square + n[k] * n[k]);
    along = Number(along + n[k] * Number(wish[k]));
  }
  if (d == 2 && !point.tangent) return {n, {n[1], Number(-n[0])}};
  Components t;
  for (std::size_t k = 0; k < d; ++k) t.push_back(Number(square * Number(wish[k]) - along * n[k]));
  if (d == 2) return {n, t};
  Components last;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = (k + 1) % 3;
    const auto j = (k + 2) % 3;
    last.push_back(Number(n[i] * t[j] - n[j] * t[i]));
  }
  return {n, t, last};
}

Directions directions_of(const ContactPoint& point, std::size_t d) {
  Directions result{directions<mpq_class>(point, d), {}};
  for (const auto& vector : directions<Enclosure>(point, d)) {
    Enclosure square;
    for (const auto& component : vector) square += component * component;
    result.lengths.push_back(sqrt(square));
  }
  return result;
}

mpq_class times_power(mpq_class number, int exponent) {
  auto* const own = number.get_mpq_t();
  if (exponent >= 0) {
    mpq_mul_2exp(own, own, static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(own, own, static_cast<mp_bitcnt_t>(-exponent));
  }
  return number;
}

// Scales each column by a power of two such that its largest entry is about 1.
std::vector<int> scale_columns(ContactMotions& motions) {
  std::vector<int> shifts(motions.count, 0);
  for (std::size_t k = 0; k < motions.count; ++k) {
    double largest = 0;
    for (std::size_t row = 0; row < motions.rows.size(); ++row) {
      const auto size = std::abs(motions.rows[row][k].get_d());
      largest = std::max(largest, size / motions.lengths[row].nearest());
    }
    if (!(largest > 0) || !std::isfinite(largest)) continue;
    shifts[k] = -std::ilogb(largest);
    for (auto& row : motions.rows) row[k] = times_power(row[k], shifts[k]);
  }
  return shifts;
}

}  // namespace

std::vector<double> ContactMotions::nearest() const {
  std::vector<double> result;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const auto& value : rows[row]) result.push_back(value.get_d() / lengths[row].nearest());
  }
  return result;
}

namespace {

// The numbers, each with an error relative to its size, rounded to a grid far below the largest.
ApproximateList on_a_grid(const Rationals& numbers, const Dyadic& share) {
  constexpr long digits = 256;
  long largest = 0;
  bool any = false;
  for (const auto& number : numbers) {
    if (sgn(number) == 0) continue;
    const long magnitude = static_cast<long>(mpz_sizeinbase(number.get_num_mpz_t(), 2)) -
                           static_cast<long>(mpz_sizeinbase(number.get_den_mpz_t(), 2)) + 1;
    largest = any ? std::max(largest, magnitude) : magnitude;
    any = true;
  }
  ApproximateList result{DyadicList(numbers.size()), {}};
  if (!any) return result;
  const long grid = largest - digits;
  result.values.exponent = grid;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    mpq_class scaled = numbers[k];
    if (grid >= 0) {
      mpq_div_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(grid));
    } else {
      mpq_mul_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(-grid));
    }
    mpz_fdiv_q(result.values.mantissas[k].get_mpz_t(), scaled.get_num_mpz_t(),
               scaled.get_den_mpz_t());
  }
  // Twice the share, since it is relative to the approximate number instead of the exact one.
  result.error = Dyadic(mpz_class(1), grid) + share.scaled(1) * Dyadic(mpz_class(1), largest);
  return result;
}

}  // namespace

ApproximateList times_lengths(const ContactMotions& motions, const Rationals& numbers) {
  Rationals products(numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (sgn(numbers[k]) != 0) products[k] = numbers[k] * motions.lengths[k].rational();
  }
  return on_a_grid(products, motions.spread);
}

ApproximateList restricted_to_candidates(const ContactMotions& motions,
                                         const Rationals& coefficients) {
  Rationals quotients(motions.rows.size());
  for (std::size_t k = 0; k < motions.rows.size(); ++k) {
    quotients[k] = dot(motions.rows[k], coefficients);
    if (sgn(quotients[k]) != 0) quotients[k] /= motions.lengths[k].rational();
  }
  return on_a_grid(quotients, motions.spread);
}

namespace {

// Modes that displace candidates, and the others; the scales of the former are those of
// scale_columns().
struct SplitModes {
  std::vector<Rationals> of_candidates;
  std::vector<Rationals> others;
};

SplitModes split_modes(const Structure& structure, const UnconstrainedBodies& bodies,
                       std::vector<Rationals>& seen_rows) {
  for (const auto& point : structure.contact) {
    for (std::size_t axis = 0; axis < structure.dimension; ++axis)
      seen_rows.push_back(bodies.at(point, axis));
  }
  // Their doubles are compared with the modes of a certificate, so modes of long levers must not be
  // nearly equal.
  Elimination visible(bodies.motions());
  visible.add_equations_largest_first(seen_rows);
  return {visible.removed(), visible.basis()};
}

}  // namespace

UnconstrainedModes unconstrained_modes(const Structure& structure) {
  const auto d = structure.dimension;
  UnconstrainedModes result;
  auto& seen = result.of_candidates;
  std::vector<Directions> frames;
  for (const auto& point : structure.contact) {
    frames.push_back(directions_of(point, d));
    for (const auto& length : frames.back().lengths) {
      seen.lengths.push_back(length.lower());
      seen.spread =
          larger(seen.spread, quotient_above(length.upper() - length.lower(), length.lower()));
    }
  }
  seen.rows.resize(seen.lengths.size());
  const UnconstrainedBodies bodies(structure);
  if (bodies.motions().empty()) return result;
  std::vector<Rationals> seen_rows;
  const auto [columns, unseen] = split_modes(structure, bodies, seen_rows);
  result.others = bodies.grounding_springs(Elimination(unseen));
  seen.count = columns.size();
  for (auto& row : seen.rows) row.resize(seen.count);
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const std::span rows(seen_rows.data() + d * i, d);
    for (std::size_t column = 0; column < columns.size(); ++column) {
      Rationals moves;
      for (const auto& row : rows) moves.push_back(dot(row, columns[column]));
      for (std::size_t k = 0; k < d; ++k)
        seen.rows[d * i + k][column] = dot(frames[i].vectors[k], moves);
    }
  }
  seen.shifts = scale_columns(seen);
  return result;
}

std::vector<LoadWork> works_of(const Structure& structure, const ContactMotions& seen,
                               const std::vector<std::vector<Force>>& loads) {
  const UnconstrainedBodies bodies(structure);
  std::vector<LoadWork> result(loads.size());
  if (bodies.motions().empty()) return result;
  std::vector<Rationals> seen_rows;
  const auto modes = split_modes(structure, bodies, seen_rows);
  for (std::size_t load = 0; load < loads.size(); ++load) {
    Rationals moved(bodies.motions().front().size());  // sum of force times displacement
    for (const auto& [node, components] : loads[load]) {
      for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
        const auto row = bodies.at(node, axis);
        for (std::size_t k = 0; k < row.size(); ++k)
          if (sgn(row[k]) != 0) moved[k] += mpq_class(components[axis]) * row[k];
      }
    }
    for (std::size_t k = 0; k < modes.of_candidates.size(); ++k)
      result[load].of_candidates.push_back(
          times_power(dot(moved, modes.of_candidates[k]), seen.shifts[k]));
    for (const auto& mode : modes.others) result[load].others.push_back(dot(moved, mode));
  }
  return result;
}

ContactMotions recorded_motions(const std::vector<double>& values, std::size_t count) {
  ContactMotions motions;
  motions.count = count;
  if (count == 0) return motions;
  for (std::size_t at = 0; at < values.size(); at += count) {
    auto& row = motions.rows.emplace_back();
    for (std::size_t k = 0; k < count; ++k) row.emplace_back(values[at + k]);
    motions.lengths.emplace_back(1.0);
  }
  return motions;
}

std::vector<std::size_t> columns_of(const ContactMotions& motions,
                                    const std::vector<std::size_t>& rows) {
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < motions.count; ++k) {
    const bool moves = std::any_of(rows.begin(), rows.end(),
                                   [&](auto row) { return sgn(motions.rows[row][k]) != 0; });
    if (moves) columns.push_back(k);
  }
  return columns;
}

ContactMotions part_of(const ContactMotions& motions, const std::vector<std::size_t>& rows) {
  ContactMotions part;
  part.spread = motions.spread;
  if (motions.count == 0) return part;
  const auto columns = columns_of(motions, rows);
  part.count = columns.size();
  for (const auto row : rows) {
    auto& own = part.rows.emplace_back();
    for (const auto k : columns) own.push_back(motions.rows[row][k]);
    part.lengths.push_back(motions.lengths[row]);
  }
  return part;
}

}  // namespace kusabi::verify
