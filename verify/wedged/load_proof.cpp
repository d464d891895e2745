// States under load: nodes below which there is none, and leaves with one. docs/theory/proofs.md
// derives them ("States under load").
#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/wedged/block_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

namespace {

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
  ActingLoad load{times(block_.loads[0].forces, dead), {}, dead, {}};
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

// With v_n = -g on U and zero elsewhere, u = u' + v: u' satisfies the conditions without gaps on U
// under the load f - K v.
void BlockProof::add_load(const ActingLoad& load, LoadShare share, Leaf& leaf) const {
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
  for (std::size_t mode = 0; mode < motions(); ++mode) {
    leaf.work.emplace_back(mpq_class(share.dead) * block_.loads[0].work[mode] +
                           mpq_class(share.reference) * block_.loads[1].work[mode]);
  }
}

std::optional<std::string> BlockProof::refusal_of_held_state(const IndexSet& contact,
                                                             const IndexSet& /*separated*/,
                                                             LoadShare share,
                                                             std::span<const double> numbers,
                                                             Grip* grip) const {
  Leaf leaf{contact, {}, {}, {}, {}, {}, {}, {}};
  add_load(acting(share), share, leaf);
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
