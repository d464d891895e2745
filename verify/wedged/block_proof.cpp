// Parts of the recorded numbers, and the proofs that they are for.
#include "verify/wedged/block_proof.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/wedged/form_proof.hpp"
#include "verify/wedged/unloaded_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

BlockProof::BlockProof(ContactBlock block)
    : model_(std::move(block)), bounds_(model_.candidates()) {}

Combination BlockProof::without_cuts(const IndexSet& contact, const IndexSet& separated,
                                     std::span<const double> numbers) const {
  return {.contact = contact,
          .separated = separated,
          .multipliers = numbers.first(model_.candidates()),
          .mean = numbers.subspan(model_.candidates(), model_.motions())};
}

Combination BlockProof::with_cuts(const IndexSet& contact, const IndexSet& separated,
                                  std::span<const double> numbers) const {
  auto result = without_cuts(contact, separated, numbers);
  const auto m = model_.candidates();
  result.of_cuts = numbers.subspan(m + model_.motions(), m);
  return result;
}

ProofResult BlockProof::prove_infeasible(const IndexSet& contact, const IndexSet& separated,
                                         std::span<const double> numbers,
                                         std::span<const LoadShare> shares,
                                         const std::optional<GripTerm>& grip,
                                         bool except_dead) const {
  auto all = without_cuts(contact, separated, numbers);
  for (const auto& share : shares) {
    all.loads.push_back(model_.acting(share));
    all.loads.back().excepted = except_dead && share == LoadShare{1, 0};
  }
  all.grip = grip;
  return InfeasibilityProof(model_, bounds_, std::move(all)).result();
}

ProofResult BlockProof::prove_by_cuts(const IndexSet& contact, const IndexSet& separated,
                                      std::span<const double> numbers) const {
  return prove_with_bounds(with_cuts(contact, separated, numbers));
}

ProofResult BlockProof::prove_by_form(std::span<const double> numbers) const {
  return verify::prove_by_form(model_, numbers);
}

std::optional<std::string> BlockProof::add_bound(std::size_t candidate, Side side,
                                                 const std::optional<double>& maximum,
                                                 std::span<const double> numbers) {
  auto combination = with_cuts({}, {}, numbers);
  (side == Side::contact ? combination.contact : combination.separated)
      .insert(static_cast<int>(candidate));
  if (maximum) {
    const double theta = numbers.back();
    if (!std::isfinite(*maximum) || *maximum <= 0 || !std::isfinite(theta) || theta <= 0) {
      return "a bound and the multiplier of its opposite must be above zero";
    }
    combination.opposite = {candidate, side, Dyadic(theta), Dyadic(theta) * Dyadic(*maximum)};
  }
  const auto proof_result = prove_with_bounds(std::move(combination));
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
  auto proof_result = combination.contact.meets(combination.separated)
                          ? ProofResult{}
                          : InfeasibilityProof(model_, bounds_, std::move(combination)).result();
  if (!proof_result.refusal && bounds_except_large_) proof_result.except_large_displacements = true;
  return proof_result;
}

bool BlockProof::leaves_a_contact_unloaded(const IndexSet& contact,
                                           const IndexSet& separated) const {
  return verify::leaves_a_contact_unloaded(model_, contact, separated);
}

std::optional<std::string> BlockProof::refusal_of_feasible(const IndexSet& contact,
                                                           std::span<const double> numbers) const {
  if (contact.empty()) return "the leaf has no candidate in contact";
  return LeafProof(model_, contact, numbers).refusal();
}

std::optional<std::string> BlockProof::refusal_of_held_state(const IndexSet& contact,
                                                             LoadShare share,
                                                             std::span<const double> numbers,
                                                             Grip* grip) const {
  return LeafProof(model_, contact, numbers, share, grip).refusal();
}

}  // namespace kusabi::verify
