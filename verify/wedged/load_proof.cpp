// States under load: nodes below which there is none, and leaves with one. docs/theory/proofs.md
// derives them ("States under load").
#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/wedged/block_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

namespace {

/// Displacement by the recorded motion, relative to the largest, below which a candidate is to be
/// at rest: the recorded numbers have sixteen digits.
constexpr double nearly_at_rest = 1e-9;

DyadicList times(const DyadicList& list, const Dyadic& factor) {
  DyadicList result(list.size());
  result.exponent = list.exponent + factor.exponent();
  const mpz_class own = factor.multiples(factor.exponent());
  for (std::size_t k = 0; k < list.size(); ++k) result.mantissas[k] = list.mantissas[k] * own;
  return result;
}

}  // namespace

BlockProof::ActingLoad BlockProof::acting(LoadShare share) const {
  const Dyadic dead(share.dead);
  const Dyadic reference(share.reference);
  ActingLoad load{times(block_.loads[0].forces, dead), {}, dead, {}, work_of(share)};
  load.forces += times(block_.loads[1].forces, reference);
  load.error = absolute(dead) * block_.loads[0].error + absolute(reference) * block_.loads[1].error;
  load.gaps = times(DyadicList(block_.clearance), dead);
  return load;
}

ProofResult BlockProof::prove_no_state(const IndexSet& contact, const IndexSet& separated,
                                       std::span<const LoadShare> shares,
                                       std::span<const double> numbers,
                                       const std::optional<GripTerm>& grip) const {
  Combination combination{.contact = contact,
                          .separated = separated,
                          .multipliers = numbers.first(candidates()),
                          .mean = numbers.subspan(candidates(), motions()),
                          .of_cuts = {},
                          .opposite = {}};
  for (const auto& share : shares) combination.loads.push_back(acting(share));
  combination.grip = grip;
  return prove(combination);
}

// L_j = w'f_j + sum_k y_k g_jk, minus the share of the grip.
std::vector<Dyadic> BlockProof::works_above(const Combination& combination, const DyadicList& w,
                                            const Dyadic& w_error, const std::vector<Dyadic>& y,
                                            const Dyadic& y_error) const {
  std::vector<Dyadic> works;
  if (combination.loads.empty()) return works;
  const auto w_size = norm_above(w) + w_error * Dyadic(static_cast<double>(w.size()));
  for (const auto& load : combination.loads) {
    auto sum = w_size * load.error;
    for (std::size_t k = 0; k < w.size(); ++k)
      sum = sum + w[k] * load.forces[k] + w_error * absolute(load.forces[k]);
    for (std::size_t k = 0; k < candidates(); ++k)
      sum = sum + y[k] * load.gaps[k] + y_error * absolute(load.gaps[k]);
    if (combination.grip) {
      sum =
          sum - Dyadic(combination.grip->multiplier) * Dyadic(combination.grip->total) * load.dead;
    }
    works.push_back(std::move(sum));
  }
  return works;
}

namespace {

// Work on a recorded motion, relative to its terms.
template <class Load>
double work_size(const Load& load, const std::vector<double>& mean) {
  double sum = 0, size = 0;
  for (std::size_t mode = 0; mode < mean.size(); ++mode) {
    sum += load.work[mode].get_d() * mean[mode];
    size += std::abs(load.work[mode].get_d() * mean[mode]);
  }
  return size == 0 ? 0 : std::abs(sum) / size;
}

}  // namespace

// The candidates hardly displaced by the recorded motion are those of wedged configurations: w is
// zero there in rational numbers, and their reactions, of any size, do no work on it.
std::optional<std::string> BlockProof::refusal_of_rigid_motion(
    Combination combination, const std::vector<double>& mean) const {
  if (combination.loads.empty()) return "a rigid motion alone excludes loads only";
  if (combination.grip && combination.grip->multiplier != 0)
    return "the sum of the reactions has a multiplier";
  const auto d = block_.dimension;
  const auto p = motions();
  std::vector<double> sizes(candidates(), 0);
  const auto directions = [&](std::size_t i) { return block_.friction[i] == 0 ? 1 : d; };
  for (std::size_t i = 0; i < candidates(); ++i) {
    for (std::size_t row = d * i; row < d * i + directions(i); ++row) {
      double sum = 0;
      for (std::size_t k = 0; k < p; ++k) sum += near_motions_[p * row + k] * mean[k];
      sizes[i] = std::max(sizes[i], std::abs(sum));
    }
  }
  const double largest = *std::ranges::max_element(sizes);
  Elimination at_rest(p);
  for (std::size_t i = 0; i < candidates(); ++i) {
    if (contains(combination.separated, i) || sizes[i] > nearly_at_rest * largest) continue;
    for (std::size_t row = d * i; row < d * i + directions(i); ++row)
      at_rest.add_equation(block_.motions.rows[row]);
    combination.separated.insert(static_cast<int>(i));  // nothing is left to be ruled out there
  }
  // Loads without the dead one may have any amount, if they do no work.
  const auto may_act = [&](const ActingLoad& load) {
    return load.dead.sign() == 0 && work_size(load, mean) <= nearly_at_rest;
  };
  for (const auto& load : combination.loads)
    if (may_act(load)) at_rest.add_equation(load.work);
  std::erase_if(combination.loads, may_act);
  if (combination.loads.empty()) return "no load with the dead one is left";
  const DyadicList zero(std::vector<Dyadic>(d * candidates()));
  const auto w = restricted_to_candidates(block_.motions, missing(mean, zero, at_rest.basis()));
  const std::vector<Dyadic> no_forces(candidates());
  const auto works = works_above(combination, w.values, w.error, no_forces, {});
  return check_margins(combination, w.values, w.error, {}, works);
}

// With v_n = -g on U and zero elsewhere, u = u' + v: u' satisfies the conditions without gaps on U
// under the load f - K v.
void BlockProof::add_load(const ActingLoad& load, Leaf& leaf) const {
  const auto d = block_.dimension;
  leaf.gaps = load.gaps;
  std::vector<Dyadic> closing(d * candidates());
  for (const int i : leaf.contact) {
    const auto own = static_cast<std::size_t>(i);
    closing[d * own] = load.gaps[own];
  }
  const DyadicList closed(closing);
  leaf.forces = load.forces;
  leaf.forces += block_.stiffness.middle * closed;
  leaf.force_error = load.error + block_.stiffness.radius * norm_above(closed);
  leaf.work = load.work;
}

Rationals BlockProof::work_of(LoadShare share) const {
  Rationals work;
  for (std::size_t mode = 0; mode < motions(); ++mode) {
    work.emplace_back(mpq_class(share.dead) * block_.loads[0].work[mode] +
                      mpq_class(share.reference) * block_.loads[1].work[mode]);
  }
  return work;
}

std::optional<std::string> BlockProof::refusal_of_held_state(const IndexSet& contact,
                                                             const IndexSet& /*separated*/,
                                                             LoadShare share,
                                                             std::span<const double> numbers,
                                                             Grip* grip) const {
  Leaf leaf{contact, {}, {}, {}, {}, {}, {}, {}};
  add_load(acting(share), leaf);
  leaf.grip = grip;
  return refusal_of_leaf(std::move(leaf), numbers);
}

bool BlockProof::resists_all_motions(const IndexSet& contact) const {
  const auto d = block_.dimension;
  Elimination free(motions());
  for (const int i : contact) {
    const auto own = static_cast<std::size_t>(i);
    const std::size_t directions = block_.friction[own] == 0 ? 1 : d;
    for (std::size_t k = 0; k < directions; ++k)
      free.add_equation(block_.motions.rows[d * own + k]);
  }
  return free.basis().empty();
}

}  // namespace kusabi::verify
