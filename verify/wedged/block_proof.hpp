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

/// Proofs of claims on one block, and the bounds of its candidates that are proved so far.
class BlockProof {
 public:
  explicit BlockProof(ContactBlock block);

  /// See BlockModel::min_eigenvalue().
  [[nodiscard]] const std::optional<Dyadic>& min_eigenvalue() const {
    return model_.min_eigenvalue();
  }

  /// Proves that below the node (U, R) there is no state under any combination of the loads with
  /// amounts >= 0 of which one is positive; without loads, that there is no wedged configuration.
  /// @param numbers m multipliers, and p coefficients of the mean motion of w
  /// @param grip a restriction of the states; nothing: all states
  /// @pre min_eigenvalue(); loads, if there are shares
  [[nodiscard]] ProofResult prove_infeasible(const support::IndexSet& contact,
                                             const support::IndexSet& separated,
                                             std::span<const double> numbers,
                                             std::span<const LoadShare> shares = {},
                                             const std::optional<GripTerm>& grip = {},
                                             bool except_dead = false) const;

  /// See BlockModel::closes_gaps().
  [[nodiscard]] bool closes_gaps(const support::IndexSet& contact) const {
    return model_.closes_gaps(contact);
  }

  /// The same without loads, with the cuts of all added bounds.
  /// @param numbers those of prove_infeasible(), then m multipliers of cuts
  /// @pre min_eigenvalue()
  [[nodiscard]] ProofResult prove_by_cuts(const support::IndexSet& contact,
                                          const support::IndexSet& separated,
                                          std::span<const double> numbers) const;

  /// Proves that no configuration of the block is wedged, by a quadratic form.
  /// @param numbers m^2 multipliers of products, (d - 1) m^2 of slips, m of squares and, with
  ///        motions, m^2 of products of displacements
  /// @pre min_eigenvalue()
  [[nodiscard]] ProofResult prove_by_form(std::span<const double> numbers) const;

  /// Proves a bound of a candidate, or that it is never in contact (never separated), with the cuts
  /// of the bounds added before, and adds it. @return the reason if it is not proved
  /// @param maximum bound of r_n (side: contact) or u_n (separated) over sum_k r_nk; nothing: no
  ///        configuration has the candidate on this side
  /// @param numbers those of prove_by_cuts(), and with `maximum` the multiplier of its opposite
  /// @pre min_eigenvalue()
  [[nodiscard]] std::optional<std::string> add_bound(std::size_t candidate, Side side,
                                                     const std::optional<double>& maximum,
                                                     std::span<const double> numbers);

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
  // Parts of the recorded numbers, without cuts.
  [[nodiscard]] Combination without_cuts(const support::IndexSet& contact,
                                         const support::IndexSet& separated,
                                         std::span<const double> numbers) const;
  // The same with the multipliers of cuts.
  [[nodiscard]] Combination with_cuts(const support::IndexSet& contact,
                                      const support::IndexSet& separated,
                                      std::span<const double> numbers) const;
  // Proves that no configuration satisfies the inequalities, with all proved bounds.
  [[nodiscard]] ProofResult prove_with_bounds(Combination combination) const;

  BlockModel model_;
  ProvedBounds bounds_;
  bool bounds_except_large_ = false;  // some bounds hold except for large displacements
};

}  // namespace kusabi::verify
