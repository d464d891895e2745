// Dead nodes: no configuration below them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/balance.hpp"
#include "verify/block_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

namespace {

// A multiplier below this share of the largest may be one that is zero but for a barrier.
constexpr double small_multiplier = 1e-6;

// By so much of the largest, and more if need be, a multiplier that may not be negative is raised
// where equilibrium hangs on the last digits of directions.
constexpr double spare = 0x1p-40;

// Zero where a number is below a share of the largest.
std::vector<double> without_small(std::span<const double> numbers, double share) {
  double largest = 0;
  for (const double number : numbers) largest = std::max(largest, std::abs(number));
  std::vector<double> rest;
  for (const double number : numbers)
    rest.push_back(std::abs(number) < share * largest ? 0 : number);
  return rest;
}

constexpr auto not_in_equilibrium =
    "its multipliers are not in equilibrium, or some are negative where u_n >= 0";

}  // namespace

Judgement BlockProof::judge_dead(const IndexSet& contact, const IndexSet& separated,
                                 std::span<const double> numbers) const {
  if (separated == IndexSet::below(static_cast<int>(candidates())))
    return {};  // r = 0, nothing else
  const auto recorded = numbers.first(candidates());
  if (motions() == 0) return {refusal_of_held(contact, separated, recorded)};
  const auto mean = own_coefficients(numbers.subspan(candidates()));
  const auto refusal = [&](const std::optional<Multipliers>& y) -> std::optional<std::string> {
    if (!y) return not_in_equilibrium;
    const auto all = first_numbers(block_.dimension * candidates());
    return held_.front().guess(all, y->near.values, [&](const auto& w, const auto& nu) {
      return check_dead(separated, *y, mean, w, nu);
    });
  };
  std::optional<std::string> first;
  // All of them; without those that a solver had to keep above zero; the motion alone; with some
  // more of those that may be raised.
  for (const auto& [share, raised] :
       {std::pair{0.0, 0.0}, {small_multiplier, 0.0}, {2.0, 0.0}, {small_multiplier, spare}}) {
    auto why = refusal(multipliers(contact, without_small(recorded, share), raised));
    if (!why) return {};
    if (!first) first = std::move(why);
  }
  for (const double share : {0.0, small_multiplier}) {
    if (!refusal(near_multipliers(contact, without_small(recorded, share)))) return {{}, true};
  }
  return {first};
}

std::optional<std::string> BlockProof::refusal_of_held(const IndexSet& contact,
                                                       const IndexSet& separated,
                                                       std::span<const double> recorded) const {
  const auto all = first_numbers(block_.dimension * candidates());
  std::vector<double> y(all.size(), 0);
  for (std::size_t i = 0; i < candidates(); ++i) y[block_.dimension * i] = recorded[i];
  return held_.front().guess(all, DyadicList(y), [&](const auto& w, const auto& nu) {
    return check_dead_held(contact, separated, w, nu);
  });
}

BlockProof::Recorded BlockProof::recorded_forces(const IndexSet& contact,
                                                 std::span<const double> recorded,
                                                 double raised) const {
  Recorded result;
  double most = 0;
  for (const double y : recorded) most = std::max(most, std::abs(y));
  for (std::size_t i = 0; i < candidates(); ++i) {
    const auto row = block_.dimension * i;
    const bool free = holds(contact, i);
    const double y = free || recorded[i] > 0 ? recorded[i] : 0;
    const double force = y / block_.motions.lengths[row].nearest();
    result.rows.push_back(block_.motions.rows[row]);
    result.forces.emplace_back(force);
    result.room.push_back(free ? most : std::max(force, raised * most));
  }
  return result;
}

std::optional<BlockProof::Multipliers> BlockProof::multipliers(const IndexSet& contact,
                                                               std::span<const double> recorded,
                                                               double raised) const {
  auto [rows, forces, room] = recorded_forces(contact, recorded, raised);
  // Those that would become negative are zero, and the others do it: one less at each turn.
  while (true) {
    const auto exact = balanced(rows, forces, room);
    if (!exact) return {};
    bool all_allowed = true;
    for (std::size_t i = 0; i < candidates(); ++i) {
      if (holds(contact, i) || sgn((*exact)[i]) >= 0) continue;
      all_allowed = false;
      forces[i] = 0;
      room[i] = 0;
    }
    if (all_allowed) return Multipliers{along_normals(*exact), {}};
  }
}

// Directions that hardly have a part in equilibrium are left as they are.
std::optional<BlockProof::Multipliers> BlockProof::near_multipliers(
    const IndexSet& contact, std::span<const double> recorded) const {
  auto [rows, forces, room] = recorded_forces(contact, recorded, 0);
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    const auto near = nearly_balanced(rows, forces, room);
    if (!near) return {};
    for (std::size_t i = 0; i < candidates(); ++i) {
      const double force = (*near)[i].get_d();  // as many digits as it was recorded with
      forces[i] = holds(contact, i) ? force : std::max(force, 0.0);
    }
  }
  auto carried = carried_by_springs(rows, forces);
  if (!carried) return {};
  return Multipliers{along_normals(forces), std::move(*carried)};
}

std::optional<Dyadic> BlockProof::carried_by_springs(const std::vector<Rationals>& rows,
                                                     const Rationals& forces) const {
  const auto& springs = held_.front().springs();
  std::vector<Rationals> equations;
  Rationals loads;
  for (std::size_t motion = 0; motion < motions(); ++motion) {
    auto& equation = equations.emplace_back();
    for (const auto spring : springs) equation.push_back(block_.motions.rows[spring][motion]);
    auto& load = loads.emplace_back();
    for (std::size_t k = 0; k < rows.size(); ++k) load += forces[k] * rows[k][motion];
  }
  const auto shares = solution(std::move(equations), std::move(loads));
  if (!shares) return {};
  Rationals everywhere(block_.motions.rows.size());
  for (std::size_t k = 0; k < springs.size(); ++k) everywhere[springs[k]] = (*shares)[k];
  const auto near = times_lengths(block_.motions, everywhere);
  return norm_above(near.values) + near.error * Dyadic(static_cast<double>(springs.size()));
}

NearList BlockProof::along_normals(const Rationals& forces) const {
  Rationals everywhere(block_.dimension * candidates());
  for (std::size_t i = 0; i < candidates(); ++i) everywhere[block_.dimension * i] = forces[i];
  return times_lengths(block_.motions, everywhere);
}

// w with K w = nu near y, and a motion more: it does no work in equilibrium.
std::optional<std::string> BlockProof::check_dead(const IndexSet& separated, const Multipliers& y,
                                                  const std::vector<double>& mean,
                                                  const DyadicList& w, const DyadicList& nu) const {
  std::vector<Rationals> motions_of_block = Elimination(motions()).left();
  const auto shift = seen_of(block_.motions, missing(mean, w, motions_of_block));
  auto moved = w;
  moved += shift.values;
  const Dyadic count(static_cast<double>(w.size()));
  Dyadic square_sum;
  for (std::size_t k = 0; k < w.size(); ++k)
    square_sum = square_sum + square(nu[k] - y.near.values[k]);
  const auto epsilon = sqrt_above(square_sum) + count * y.near.error + held_.front().spread(w) +
                       Dyadic(farthest_motion) * y.carried;
  return check_margins(separated, moved, shift.error, epsilon);
}

// Nothing is loose: what K w is stands for the multipliers.
std::optional<std::string> BlockProof::check_dead_held(const IndexSet& contact,
                                                       const IndexSet& separated,
                                                       const DyadicList& w,
                                                       const DyadicList& nu) const {
  const auto d = block_.dimension;
  Dyadic epsilon_squared;
  for (std::size_t i = 0; i < candidates(); ++i) {
    epsilon_squared = epsilon_squared + tangential_square(nu, i);
    const auto normal = nu[d * i];
    if (!holds(contact, i) && normal.sign() < 0) {
      epsilon_squared = epsilon_squared + square(normal);
    }
  }
  return check_margins(separated, w, {}, sqrt_above(epsilon_squared) + held_.front().spread(w));
}

Dyadic BlockProof::slip_above(const DyadicList& w, std::size_t candidate,
                              const Dyadic& error) const {
  const auto& mu = friction_[candidate];
  const auto off = error * (Dyadic(1.0) + mu.scaled(1));  // |w_t| of at most two numbers
  return sqrt_above(square(mu) * tangential_square(w, candidate)) + off;
}

// w'r >= -epsilon |u|, where each number of w may be off by `error`.
std::optional<std::string> BlockProof::check_margins(const IndexSet& separated, const DyadicList& w,
                                                     const Dyadic& error,
                                                     const Dyadic& epsilon) const {
  const auto d = block_.dimension;
  std::optional<Dyadic> delta;
  for (std::size_t i = 0; i < candidates(); ++i) {
    if (holds(separated, i)) continue;
    const auto margin = Dyadic{} - w[d * i] - slip_above(w, i, error);
    if (margin.sign() <= 0) {
      return "its multipliers do not rule out a reaction at " + block_.names[i];
    }
    if (!delta || margin < *delta) delta = margin;
  }
  if (*delta * *least_ > epsilon * steepest_) return {};
  return "its multipliers rule out too little, or ask for what u_n >= 0 does not give";
}

}  // namespace kusabi::verify
