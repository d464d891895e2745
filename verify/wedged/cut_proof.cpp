// Infeasible nodes that require bounds of candidates, and proofs of these bounds: nodes with the
// opposite of the bound as an additional inequality.
#include <algorithm>
#include <cmath>
#include <vector>

#include "verify/wedged/block_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

ProofResult BlockProof::prove_by_cuts(const IndexSet& contact, const IndexSet& separated,
                                      std::span<const double> numbers) const {
  return prove_with_bounds({.contact = contact,
                            .separated = separated,
                            .multipliers = numbers.first(candidates()),
                            .mean = numbers.subspan(candidates(), motions()),
                            .of_cuts = numbers.subspan(candidates() + motions(), candidates()),
                            .opposite = {}});
}

std::optional<std::string> BlockProof::add_bound(std::size_t candidate, Side side,
                                                 const std::optional<double>& maximum,
                                                 std::span<const double> numbers) {
  Combination combination{.contact = {},
                          .separated = {},
                          .multipliers = numbers.first(candidates()),
                          .mean = numbers.subspan(candidates(), motions()),
                          .of_cuts = numbers.subspan(candidates() + motions(), candidates()),
                          .opposite = {}};
  (side == Side::contact ? combination.contact : combination.separated)
      .insert(static_cast<int>(candidate));
  if (maximum) {
    const double theta = numbers.back();
    if (!std::isfinite(*maximum) || *maximum <= 0 || !std::isfinite(theta) || theta <= 0) {
      return "a bound and the multiplier of its opposite must be above zero";
    }
    combination.opposite = {candidate, side, Dyadic(theta), Dyadic(theta) * Dyadic(*maximum)};
  }
  const auto proof_result = prove_with_bounds(combination);
  if (proof_result.refusal) return proof_result.refusal;
  bounds_except_large_ = bounds_except_large_ || proof_result.except_large_displacements;
  if (maximum) {
    bounds_.limit(candidate, side, *maximum);
  } else {
    bounds_.exclude(candidate, side);
  }
  return {};
}

ProofResult BlockProof::prove_with_bounds(Combination combination) const {
  const auto eta = combination.of_cuts;
  if (!all_finite(combination.multipliers) || !all_finite(combination.mean) || !all_finite(eta)) {
    return {"its numbers are too large to compute with"};
  }
  if (std::any_of(eta.begin(), eta.end(), [](double x) { return x < 0; })) {
    return {"a multiplier of a cut is negative"};
  }
  combination.contact |= bounds_.in_contact();
  combination.separated |= bounds_.separated();
  // A candidate that must be on both sides excludes every configuration.
  auto proof_result =
      combination.contact.meets(combination.separated) ? ProofResult{} : prove(combination);
  if (!proof_result.refusal && bounds_except_large_) proof_result.except_large_displacements = true;
  return proof_result;
}

// Coefficient of u_nk in the inequalities, beside nu_nk.
Dyadic BlockProof::displacement_share(const Combination& combination, std::size_t k) const {
  if (combination.of_cuts.empty()) return {};
  const auto& opposite = combination.opposite;
  const auto cut = Dyadic(combination.of_cuts[k]) * bounds_.gap_share(k);
  const bool opposed = opposite && opposite->side == Side::separated && opposite->candidate == k;
  return opposed ? cut - opposite->multiplier : cut;
}

// w~ - w: sum_l eta_l - eta_k B_k - theta beta + theta [k = i, in contact] at the normals.
DyadicList BlockProof::reaction_shares(const Combination& combination) const {
  const auto d = block_.dimension;
  std::vector<Dyadic> shares(d * candidates());
  if (combination.grip) {
    for (std::size_t k = 0; k < candidates(); ++k)
      shares[d * k] = Dyadic(combination.grip->multiplier);
  }
  if (combination.of_cuts.empty()) return DyadicList(shares);
  const auto& opposite = combination.opposite;
  Dyadic everywhere;
  for (const double eta : combination.of_cuts) everywhere = everywhere + Dyadic(eta);
  if (opposite) everywhere = everywhere - opposite->of_sum;
  for (std::size_t k = 0; k < candidates(); ++k) {
    auto& own = shares[d * k];
    own = everywhere - Dyadic(combination.of_cuts[k]) * bounds_.reaction_share(k);
    if (opposite && opposite->side == Side::contact && opposite->candidate == k) {
      own = own + opposite->multiplier;
    }
  }
  return DyadicList(shares);
}

}  // namespace kusabi::verify
