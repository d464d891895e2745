// Equilibrium by changes that are small in the units of each multiplier.
#include "verify/wedged/equilibrium_multipliers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/arithmetic/balance.hpp"

namespace kusabi::verify {

// Lower bound of the force: y_k is the force times a length with a bounded relative error, and at
// least minus the coefficient of u_nk in the inequalities.
mpq_class EquilibriumMultipliers::min_force(std::size_t k) const {
  const auto& share = shares_[k];
  if (share.sign() == 0) return 0;
  const auto& length = block_.motions.lengths[block_.dimension * k];
  const auto off = length * block_.motions.spread;
  return -share.rational() / (share.sign() > 0 ? length + off : length - off).rational();
}

EquilibriumMultipliers::Recorded EquilibriumMultipliers::recorded_forces(double small,
                                                                         double raised) const {
  Recorded result;
  double maximum = 0;
  for (const double y : multipliers_) maximum = std::max(maximum, std::abs(y));
  for (std::size_t i = 0; i < model_.candidates(); ++i) {
    const auto row = block_.dimension * i;
    const bool free = contains(contact_, i);
    result.rows.push_back(block_.motions.rows[row]);
    result.minimum.push_back(free ? mpq_class(0) : min_force(i));
    const auto& minimum = result.minimum.back();
    const double length = block_.motions.lengths[row].nearest();
    // The part above the lower bound; zero if it is small.
    double more = multipliers_[i] / length - minimum.get_d();
    if (std::abs(more) * length < small * maximum || !std::isfinite(more)) more = 0;
    if (!free) more = std::max(more, 0.0);
    result.forces.push_back(minimum + mpq_class(more));
    result.room.push_back(free ? maximum : std::max(more, raised * maximum));
  }
  return result;
}

std::optional<Multipliers> EquilibriumMultipliers::exact(double small, double raised) const {
  auto [rows, forces, minimum, room] = recorded_forces(small, raised);
  // Forces that would fall below their lower bounds are fixed there, and the others are corrected;
  // one more is fixed in each round.
  while (true) {
    const auto exact = balanced(rows, forces, room);
    if (!exact) return {};
    bool all_allowed = true;
    for (std::size_t i = 0; i < model_.candidates(); ++i) {
      if (contains(contact_, i) || (*exact)[i] >= minimum[i]) continue;
      all_allowed = false;
      forces[i] = minimum[i];
      room[i] = 0;
    }
    if (all_allowed) return Multipliers{along_normals(*exact), {}};
  }
}

// Directions with almost no part in equilibrium are not corrected.
std::optional<Multipliers> EquilibriumMultipliers::nearly(double small) const {
  auto [rows, forces, minimum, room] = recorded_forces(small, 0);
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    const auto near = nearly_balanced(rows, forces, room);
    if (!near) return {};
    for (std::size_t i = 0; i < model_.candidates(); ++i) {
      forces[i] = mpq_class((*near)[i].get_d());  // as many digits as were recorded
      if (!contains(contact_, i) && forces[i] < minimum[i]) forces[i] = minimum[i];
    }
  }
  auto carried = carried_by_springs(rows, forces);
  if (!carried) return {};
  return Multipliers{along_normals(forces), std::move(*carried)};
}

std::optional<Dyadic> EquilibriumMultipliers::carried_by_springs(const std::vector<Rationals>& rows,
                                                                 const Rationals& forces) const {
  const auto& springs = model_.first_regularised().springs();
  std::vector<Rationals> equations;
  Rationals loads;
  for (std::size_t motion = 0; motion < model_.motions(); ++motion) {
    auto& equation = equations.emplace_back();
    for (const auto spring : springs) equation.push_back(block_.motions.rows[spring][motion]);
    auto& load = loads.emplace_back();
    for (std::size_t k = 0; k < rows.size(); ++k) load += forces[k] * rows[k][motion];
  }
  const auto shares = solution(std::move(equations), loads);
  if (!shares) return {};
  Rationals everywhere(block_.motions.rows.size());
  for (std::size_t k = 0; k < springs.size(); ++k) everywhere[springs[k]] = (*shares)[k];
  const auto near = times_lengths(block_.motions, everywhere);
  return norm_above(near.values) + near.error * Dyadic(static_cast<double>(springs.size()));
}

ApproximateList EquilibriumMultipliers::along_normals(const Rationals& forces) const {
  Rationals everywhere(block_.dimension * model_.candidates());
  for (std::size_t i = 0; i < model_.candidates(); ++i)
    everywhere[block_.dimension * i] = forces[i];
  return times_lengths(block_.motions, everywhere);
}

}  // namespace kusabi::verify
