// Infeasible nodes: no configuration below them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "verify/arithmetic/balance.hpp"
#include "verify/wedged/block_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

namespace {

// Multipliers below this share of the largest may be positive only because of the barrier of the
// interior-point method.
constexpr double small_multiplier = 1e-6;

// Share of the largest by which a nonnegative multiplier is raised if equilibrium depends on the
// last digits of directions; larger shares are tried if necessary.
constexpr double spare = 0x1p-40;

constexpr auto not_in_equilibrium =
    "its multipliers are not in equilibrium, or some are negative where u_n >= 0";

// A double that is not below a number.
double not_below(const Dyadic& number) {
  if (number.sign() == 0) return 0;
  return std::nextafter(number.nearest(), std::numeric_limits<double>::infinity());
}

}  // namespace

ProofResult BlockProof::prove_infeasible(const IndexSet& contact, const IndexSet& separated,
                                         std::span<const double> numbers) const {
  return prove({.contact = contact,
                .separated = separated,
                .multipliers = numbers.first(candidates()),
                .mean = numbers.subspan(candidates()),
                .of_cuts = {},
                .opposite = {}});
}

ProofResult BlockProof::prove(const Combination& combination) const {
  const bool unloaded = combination.separated == IndexSet::below(static_cast<int>(candidates()));
  if (unloaded && combination.loads.empty()) return {};  // r = 0 is the only solution
  return motions() == 0 ? ProofResult{refusal_of_constrained(combination)}
                        : prove_unconstrained(combination);
}

ProofResult BlockProof::prove_unconstrained(const Combination& combination) const {
  const auto mean = own_coefficients(combination.mean);
  const auto refusal = [&](const std::optional<Multipliers>& y) -> std::optional<std::string> {
    if (!y) return not_in_equilibrium;
    const auto all = first_numbers(block_.dimension * candidates());
    return regularised_.front().solve(
        all, y->near.values, [&](const auto& w, const auto& nu, const auto& off) {
          return check_unconstrained(combination, *y, mean, w, nu, off);
        });
  };
  std::optional<std::string> first;
  // The attempts: all multipliers; without those that are positive only by the barrier; the
  // rigid-body mode alone; with some nonnegative ones raised.
  for (const auto& [small, raised] :
       {std::pair{0.0, 0.0}, {small_multiplier, 0.0}, {2.0, 0.0}, {small_multiplier, spare}}) {
    auto why = refusal(multipliers(combination, small, raised));
    if (!why) return {};
    if (!first) first = std::move(why);
  }
  if (!refusal_of_rigid_motion(combination, mean)) return {};
  for (const double small : {0.0, small_multiplier}) {
    if (!refusal(near_multipliers(combination, small))) return {{}, true};
  }
  return {first};
}

std::optional<std::string> BlockProof::refusal_of_constrained(
    const Combination& combination) const {
  const auto all = first_numbers(block_.dimension * candidates());
  std::vector<double> y(all.size(), 0);
  for (std::size_t k = 0; k < candidates(); ++k) {
    auto& own = y[block_.dimension * k];
    own = combination.multipliers[k];
    // The recorded value up to rounding, and at least the coefficient of u_n >= 0 and the cut.
    if (!combination.of_cuts.empty() && !contains(combination.contact, k)) {
      own = std::max(own, not_below(Dyadic() - displacement_share(combination, k)));
    }
    if (!std::isfinite(own)) return "its numbers are too large to compute with";
  }
  return regularised_.front().solve(all, DyadicList(y),
                                    [&](const auto& w, const auto& nu, const auto& off) {
                                      return check_constrained(combination, w, nu, off);
                                    });
}

// Lower bound of the force: y_k is the force times a length with a bounded relative error, and at
// least minus the coefficient of u_nk in the inequalities.
mpq_class BlockProof::min_force(const Combination& combination, std::size_t k) const {
  const auto share = displacement_share(combination, k);
  if (share.sign() == 0) return 0;
  const auto& length = block_.motions.lengths[block_.dimension * k];
  const auto off = length * block_.motions.spread;
  return -share.rational() / (share.sign() > 0 ? length + off : length - off).rational();
}

BlockProof::Recorded BlockProof::recorded_forces(const Combination& combination, double small,
                                                 double raised) const {
  Recorded result;
  double maximum = 0;
  for (const double y : combination.multipliers) maximum = std::max(maximum, std::abs(y));
  for (std::size_t i = 0; i < candidates(); ++i) {
    const auto row = block_.dimension * i;
    const bool free = contains(combination.contact, i);
    result.rows.push_back(block_.motions.rows[row]);
    result.minimum.push_back(free ? mpq_class(0) : min_force(combination, i));
    const auto& minimum = result.minimum.back();
    const double length = block_.motions.lengths[row].nearest();
    // The part above the lower bound; zero if it is small.
    double more = combination.multipliers[i] / length - minimum.get_d();
    if (std::abs(more) * length < small * maximum || !std::isfinite(more)) more = 0;
    if (!free) more = std::max(more, 0.0);
    result.forces.push_back(minimum + mpq_class(more));
    result.room.push_back(free ? maximum : std::max(more, raised * maximum));
  }
  return result;
}

std::optional<BlockProof::Multipliers> BlockProof::multipliers(const Combination& combination,
                                                               double small, double raised) const {
  auto [rows, forces, minimum, room] = recorded_forces(combination, small, raised);
  // Forces that would fall below their lower bounds are fixed there, and the others are corrected;
  // one more is fixed in each round.
  while (true) {
    const auto exact = balanced(rows, forces, room);
    if (!exact) return {};
    bool all_allowed = true;
    for (std::size_t i = 0; i < candidates(); ++i) {
      if (contains(combination.contact, i) || (*exact)[i] >= minimum[i]) continue;
      all_allowed = false;
      forces[i] = minimum[i];
      room[i] = 0;
    }
    if (all_allowed) return Multipliers{along_normals(*exact), {}};
  }
}

// Directions with almost no part in equilibrium are not corrected.
std::optional<BlockProof::Multipliers> BlockProof::near_multipliers(const Combination& combination,
                                                                    double small) const {
  auto [rows, forces, minimum, room] = recorded_forces(combination, small, 0);
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    const auto near = nearly_balanced(rows, forces, room);
    if (!near) return {};
    for (std::size_t i = 0; i < candidates(); ++i) {
      forces[i] = mpq_class((*near)[i].get_d());  // as many digits as were recorded
      if (!contains(combination.contact, i) && forces[i] < minimum[i]) forces[i] = minimum[i];
    }
  }
  auto carried = carried_by_springs(rows, forces);
  if (!carried) return {};
  return Multipliers{along_normals(forces), std::move(*carried)};
}

std::optional<Dyadic> BlockProof::carried_by_springs(const std::vector<Rationals>& rows,
                                                     const Rationals& forces) const {
  const auto& springs = regularised_.front().springs();
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

ApproximateList BlockProof::along_normals(const Rationals& forces) const {
  Rationals everywhere(block_.dimension * candidates());
  for (std::size_t i = 0; i < candidates(); ++i) everywhere[block_.dimension * i] = forces[i];
  return times_lengths(block_.motions, everywhere);
}

// w with K w = nu close to y, plus a rigid-body mode, which does no work in equilibrium.
std::optional<std::string> BlockProof::check_unconstrained(
    const Combination& combination, const Multipliers& y, const std::vector<double>& mean,
    const DyadicList& w, const DyadicList& nu, const Dyadic& off) const {
  std::vector<Rationals> motions_of_block = Elimination(motions()).basis();
  const auto shift = restricted_to_candidates(block_.motions, missing(mean, w, motions_of_block));
  auto moved = w;
  moved += shift.values;
  std::vector<Dyadic> forces;
  for (std::size_t k = 0; k < candidates(); ++k)
    forces.push_back(y.near.values[block_.dimension * k]);
  const auto works = works_above(combination, moved, shift.error, forces, y.near.error);
  moved += reaction_shares(combination);
  const Dyadic count(static_cast<double>(w.size()));
  Dyadic square_sum;
  for (std::size_t k = 0; k < w.size(); ++k)
    square_sum = square_sum + square(nu[k] - y.near.values[k]);
  const auto epsilon = sqrt_above(square_sum) + count * y.near.error + off +
                       Dyadic(largest_displacement_ratio) * y.carried;
  return check_margins(combination, moved, shift.error, epsilon, works);
}

// sum_k w~_k'r_k >= sum_k (nu_nk + eta_k A_k - theta [k = i, separated]) u_nk + nu_t'u_t.
std::optional<std::string> BlockProof::check_constrained(const Combination& combination,
                                                         const DyadicList& w, const DyadicList& nu,
                                                         const Dyadic& off) const {
  Dyadic epsilon_squared;
  std::vector<Dyadic> forces;
  for (std::size_t k = 0; k < candidates(); ++k) {
    epsilon_squared = epsilon_squared + tangential_square(nu, k);
    auto normal = nu[block_.dimension * k] + displacement_share(combination, k);
    const bool negative = !contains(combination.contact, k) && normal.sign() < 0;
    if (negative) epsilon_squared = epsilon_squared + square(normal);
    forces.push_back(negative ? Dyadic() : std::move(normal));
  }
  const auto works = works_above(combination, w, {}, forces, {});
  auto lifted = w;
  lifted += reaction_shares(combination);
  return check_margins(combination, lifted, {}, sqrt_above(epsilon_squared) + off, works);
}

Dyadic BlockProof::slip_above(const DyadicList& w, std::size_t candidate,
                              const Dyadic& error) const {
  const auto& mu = friction_[candidate];
  const auto off =
      error * (Dyadic(1.0) + mu.scaled(1));  // bound of |w_t| for at most two components
  return sqrt_above(square(mu) * tangential_square(w, candidate)) + off;
}

// w'r + sum_j L_j tau_j >= -epsilon |u|, where each number of w has an error up to `error`, and
// |u| <= (|r| + sum_j |f_j| tau_j) / s.
std::optional<std::string> BlockProof::check_margins(const Combination& combination,
                                                     const DyadicList& w, const Dyadic& error,
                                                     const Dyadic& epsilon,
                                                     const std::vector<Dyadic>& works) const {
  const auto d = block_.dimension;
  constexpr auto too_little = "the margin of its multipliers is within the rounding errors";
  std::optional<Dyadic> delta;
  for (std::size_t i = 0; i < candidates(); ++i) {
    if (contains(combination.separated, i)) continue;
    const auto margin = Dyadic{} - w[d * i] - slip_above(w, i, error);
    if (margin.sign() <= 0) {
      return "its multipliers do not rule out a reaction at " + block_.names[i];
    }
    if (!delta || margin < *delta) delta = margin;
  }
  if (delta && !(*delta * *minimum_ > epsilon * steepest_)) return too_little;
  for (std::size_t j = 0; j < works.size(); ++j) {
    if (works[j].sign() >= 0) return "its multipliers do not rule out the load";
    const auto& load = combination.loads[j];
    const auto size = norm_above(load.forces) + load.error;
    if (!((Dyadic() - works[j]) * *minimum_ > epsilon * size)) return too_little;
  }
  return {};
}

}  // namespace kusabi::verify
