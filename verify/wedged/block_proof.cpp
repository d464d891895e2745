// Parts of the recorded numbers, and the proofs that they are for.
#include "verify/wedged/block_proof.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "verify/wedged/form_proof.hpp"
#include "verify/wedged/unloaded_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

BlockProof::BlockProof(ContactBlock block)
    : model_(std::move(block)), no_bounds_(model_.candidates()) {}

Combination BlockProof::combination(const Theorem& theorem, const IndexSet& contact,
                                    const IndexSet& separated, std::span<const double> numbers,
                                    bool cuts) const {
  const auto m = model_.candidates();
  Combination all{.contact = contact,
                  .separated = separated,
                  .multipliers = numbers.first(m),
                  .mean = numbers.subspan(m, model_.motions())};
  auto rest = numbers.subspan(m + model_.motions());
  if (theorem.grip) {
    all.grip = GripTerm{theorem.grip->kind, theorem.grip->total, rest.front()};
    rest = rest.subspan(1);
  }
  if (cuts) all.of_cuts = rest.first(m);
  for (std::size_t j = 0; j < theorem.shares.size(); ++j) {
    const auto& share = theorem.shares[j];
    auto& load = all.loads.emplace_back(model_.acting(share));
    load.excepted = theorem.except_dead && share == LoadShare{1, 0};
    if (cuts) load.weight = Dyadic(theorem.weights[j]);
  }
  return all;
}

ProofResult BlockProof::prove_infeasible(const Theorem& theorem, const IndexSet& contact,
                                         const IndexSet& separated,
                                         std::span<const double> numbers) const {
  return InfeasibilityProof(model_, no_bounds_,
                            combination(theorem, contact, separated, numbers, false))
      .result();
}

ProofResult BlockProof::prove_by_cuts(const Theorem& theorem, const ProvedBounds& bounds,
                                      const IndexSet& contact, const IndexSet& separated,
                                      std::span<const double> numbers) const {
  return prove_with_bounds(combination(theorem, contact, separated, numbers, true), bounds);
}

ProofResult BlockProof::prove_by_form(std::span<const double> numbers) const {
  return verify::prove_by_form(model_, numbers);
}

std::optional<std::string> BlockProof::add_bound(const Theorem& theorem,
                                                 const CandidateBound& bound, std::size_t candidate,
                                                 ProvedBounds& bounds) const {
  const auto& [maximum, numbers] = std::tie(bound.maximum, bound.numbers);
  auto all = combination(theorem, {}, {}, numbers, true);
  (bound.side == Side::contact ? all.contact : all.separated).insert(static_cast<int>(candidate));
  if (maximum) {
    const double theta = numbers.back();
    if (!std::isfinite(*maximum) || *maximum <= 0 || !std::isfinite(theta) || theta <= 0) {
      return "a bound and the multiplier of its opposite must be above zero";
    }
    all.opposite = {candidate, bound.side, Dyadic(theta), Dyadic(theta) * Dyadic(*maximum)};
  }
  const auto proof_result = prove_with_bounds(std::move(all), bounds);
  if (proof_result.refusal) return proof_result.refusal;
  if (proof_result.except_large_displacements) bounds.leave_out_large_displacements();
  if (maximum) {
    bounds.limit(candidate, bound.side, *maximum);
  } else {
    bounds.exclude(candidate, bound.side);
  }
  return {};
}

ProofResult BlockProof::prove_with_bounds(Combination combination,
                                          const ProvedBounds& bounds) const {
  const auto eta = combination.of_cuts;
  if (!all_finite(combination.multipliers) || !all_finite(combination.mean) || !all_finite(eta)) {
    return {"its numbers are too large to compute with"};
  }
  if (std::any_of(eta.begin(), eta.end(), [](double x) { return x < 0; })) {
    return {"a multiplier of a cut is negative"};
  }
  combination.contact |= bounds.in_contact();
  combination.separated |= bounds.separated();
  // A candidate that must be on both sides excludes every state.
  auto proof_result = combination.contact.meets(combination.separated)
                          ? ProofResult{}
                          : InfeasibilityProof(model_, bounds, std::move(combination)).result();
  if (!proof_result.refusal && bounds.except_large_displacements())
    proof_result.except_large_displacements = true;
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
