// InfeasibilityProof: no configuration satisfies a set of inequalities with multipliers, such as
// those below an infeasible node, with the opposite of a bound, or under loads.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/index_set.hpp"
#include "verify/wedged/block_model.hpp"
#include "verify/wedged/equilibrium_multipliers.hpp"
#include "verify/wedged/proof_result.hpp"
#include "verify/wedged/proved_bounds.hpp"

namespace kusabi::verify {

/// The sum of the normal reactions of the block is related to the dead load: sum r_n = total, or >=
/// (<=) with a multiplier that is not negative (not positive).
struct GripTerm {
  GripBound::Kind kind = GripBound::Kind::equal;
  double total = 0;
  double multiplier = 0;
};

/// The negation of a bound: r_ni, or v_ni, is at least beta s.
struct Opposite {
  std::size_t candidate;  ///< i
  Side side;
  Dyadic multiplier;  ///< theta
  Dyadic of_sum;      ///< theta beta
};

/// Inequalities of all configurations below a node (U, R), with multipliers.
struct Combination {
  support::IndexSet contact;
  support::IndexSet separated;
  std::span<const double> multipliers;  ///< y, the target of K w
  std::span<const double> mean{};       ///< the mean motion of w, for unconstrained bodies
  std::span<const double> of_cuts{};    ///< eta; empty: no cuts
  std::optional<Opposite> opposite{};
  std::vector<ActingLoad> loads{};
  std::optional<GripTerm> grip{};
};

/// The proof of one claim.
class InfeasibilityProof {
 public:
  /// @pre model and bounds outlive this object; model.min_eigenvalue(); finite numbers of cuts
  InfeasibilityProof(const BlockModel& model, const ProvedBounds& bounds, Combination combination);

  [[nodiscard]] ProofResult result() const;

 private:
  [[nodiscard]] std::optional<std::string> refusal_of_constrained() const;
  [[nodiscard]] std::optional<std::string> check_constrained(const DyadicList& w,
                                                             const DyadicList& nu,
                                                             const Dyadic& off) const;
  [[nodiscard]] ProofResult prove_unconstrained() const;
  // Proves by a rigid motion alone that no load of the combination is held, although there may be
  // wedged configurations.
  // @param mean the motion, in the block's modes
  // @param small relative displacement below which a candidate is to be at rest
  [[nodiscard]] std::optional<std::string> refusal_of_rigid_motion(const std::vector<double>& mean,
                                                                   double small) const;
  [[nodiscard]] std::optional<std::string> check_unconstrained(const Multipliers& y,
                                                               const std::vector<double>& mean,
                                                               const DyadicList& w,
                                                               const DyadicList& nu,
                                                               const Dyadic& off) const;
  // @param works upper bounds, by load
  [[nodiscard]] std::optional<std::string> check_margins(const DyadicList& w, const Dyadic& error,
                                                         const Dyadic& epsilon,
                                                         const std::vector<Dyadic>& works) const;
  // Upper bounds of the works of the loads: w'f + sum_k y_k g_k.
  [[nodiscard]] std::vector<Dyadic> works_above(const DyadicList& w, const Dyadic& w_error,
                                                const std::vector<Dyadic>& y,
                                                const Dyadic& y_error) const;
  // Coefficients of v_nk besides the multipliers, of s, and of r besides w.
  [[nodiscard]] Dyadic displacement_share(std::size_t k) const;
  [[nodiscard]] Dyadic sum_share() const;
  [[nodiscard]] DyadicList reaction_shares() const;

  const BlockModel& model_;
  const ContactBlock& block_;
  const ProvedBounds& bounds_;
  Combination combination_;
  std::vector<Dyadic> shares_;  // of the displacements, m
};

}  // namespace kusabi::verify
