// Proofs for one block of contact candidates, for every K within an enclosure: K is positive
// definite up to rigid-body modes, no configuration is wedged below an infeasible node, and a
// feasible leaf has a configuration. docs/theory/proofs.md derives them with the same letters.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "support/index_set.hpp"
#include "verify/wedged/block_model.hpp"
#include "verify/wedged/infeasibility_proof.hpp"
#include "verify/wedged/leaf_proof.hpp"
#include "verify/wedged/proof_result.hpp"
#include "verify/wedged/proved_bounds.hpp"

namespace kusabi::verify {

/// Proofs of claims on one block. Theorems are about this block; their bounds are those proved so far.
class BlockProof {
 public:
  explicit BlockProof(ContactBlock block);

  /// See BlockModel::min_eigenvalue().
  [[nodiscard]] const std::optional<Dyadic>& min_eigenvalue() const {
    return model_.min_eigenvalue();
  }

  /// Bounds of which none is proved yet.
  [[nodiscard]] const ProvedBounds& no_bounds() const { return no_bounds_; }

  /// Proves that the theorem has no state below the node (U, R): under any combination of its loads
  /// with amounts >= 0 of which one is positive; without loads, no wedged configuration.
  /// @param numbers m multipliers, p coefficients of the mean motion of w and, if the theorem
  ///        restricts the sum of the normal reactions, its multiplier
  /// @pre min_eigenvalue(); loads, if there are shares
  [[nodiscard]] ProofResult prove_infeasible(const Theorem& theorem,
                                             const support::IndexSet& contact,
                                             const support::IndexSet& separated,
                                             std::span<const double> numbers) const;

  /// See BlockModel::closes_gaps().
  [[nodiscard]] bool closes_gaps(const support::IndexSet& contact) const {
    return model_.closes_gaps(contact);
  }

  /// The same with the cuts of its bounds.
  /// @param numbers those of prove_infeasible(), then m multipliers of cuts
  /// @pre as prove_infeasible(); weights, if there are shares
  [[nodiscard]] ProofResult prove_by_cuts(const Theorem& theorem, const ProvedBounds& bounds,
                                          const support::IndexSet& contact,
                                          const support::IndexSet& separated,
                                          std::span<const double> numbers) const;

  /// Proves that no configuration of the block is wedged, by a quadratic form.
  /// @param numbers m^2 multipliers of products, (d - 1) m^2 of slips, m of squares and, with
  ///        motions, m^2 of products of displacements
  /// @pre min_eigenvalue()
  [[nodiscard]] ProofResult prove_by_form(std::span<const double> numbers) const;

  /// Proves a bound of a candidate, or that it is never in contact (never separated), with the cuts
  /// of the bounds added before, and adds it. @return the reason if it is not proved
  /// @param candidate its number in the block
  /// @pre as prove_by_cuts()
  [[nodiscard]] std::optional<std::string> add_bound(const Theorem& theorem,
                                                     const CandidateBound& bound,
                                                     std::size_t candidate,
                                                     ProvedBounds& bounds) const;

  /// True if equilibrium makes the reaction of a contact of U zero in all configurations below the
  /// node (U, R).
  [[nodiscard]] bool leaves_a_contact_unloaded(const support::IndexSet& contact,
                                               const support::IndexSet& separated) const;

  /// Proves that the leaf with the contacts U has a configuration in its interior.
  /// @return the reason if not
  /// @param numbers tangential reactions of U, d - 1 each, and p coefficients of the mean motion
  /// @pre min_eigenvalue()
  [[nodiscard]] std::optional<std::string> refusal_of_feasible(
      const support::IndexSet& contact, std::span<const double> numbers) const;

  /// Proves that the leaf with the contacts U has a state under a load. @return the reason if not
  /// @param numbers those of refusal_of_feasible(), with displacements that are zero along the
  ///        normals of U
  /// @param grip the bounds are set; null: none are requested
  /// @pre min_eigenvalue(), loads
  [[nodiscard]] std::optional<std::string> refusal_of_held_state(const support::IndexSet& contact,
                                                                 LoadShare share,
                                                                 std::span<const double> numbers,
                                                                 Grip* grip = nullptr) const;

  /// See BlockModel::resists_all_motions().
  [[nodiscard]] bool resists_all_motions(const support::IndexSet& contact) const {
    return model_.resists_all_motions(contact);
  }

 private:
  // The inequalities with the recorded numbers. @param cuts true: with multipliers of cuts
  [[nodiscard]] Combination combination(const Theorem& theorem, const support::IndexSet& contact,
                                        const support::IndexSet& separated,
                                        std::span<const double> numbers, bool cuts) const;
  // Proves that no state satisfies the inequalities, with all proved bounds.
  [[nodiscard]] ProofResult prove_with_bounds(Combination combination,
                                              const ProvedBounds& bounds) const;

  BlockModel model_;
  ProvedBounds no_bounds_;
};

}  // namespace kusabi::verify
