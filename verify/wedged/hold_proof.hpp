// Proofs of the claims of a certificate of states under load in exact arithmetic, and the load
// factors that follow from them (docs/theory/proofs.md, "States under load").
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "verify/structure/enclosed_problem.hpp"
#include "verify/wedged/block_proof.hpp"
#include "verify/wedged/hold_certificate.hpp"

namespace kusabi::verify {

/// Sums of normal reactions are a given total up to this share of it.
inline constexpr double total_tolerance = 1e-6;

/// Factors of the reference load from `low` to `high`, both included; infinite: no end.
struct FactorRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  friend bool operator==(const FactorRange&, const FactorRange&) = default;
};

/// Bounds of the sum of the normal reactions in all states under the dead load, of a block or of
/// all candidates.
struct GripRange {
  double below = 0;               ///< no state has a smaller sum
  std::optional<double> above{};  ///< no state has a larger sum
  /// Sums of the proved states, rounded towards each other: each end is in the range.
  std::optional<FactorRange> states{};
};

/// All that the proved claims imply.
struct HoldClaims {
  std::vector<FactorRange> held{};  ///< each factor has a state; in ascending order
  std::vector<FactorRange> none{};  ///< no factor has one; in ascending order
  /// The same with normal reactions that add up to `total`.
  std::optional<double> total{};
  std::optional<GripRange> grip{};  ///< if a tree restricts a sum
};

class HoldProof {
 public:
  /// @pre the certificate outlives this object
  /// @param clearances g, m
  HoldProof(const HoldCertificate& certificate, const LoadedEnclosure& enclosure,
            const std::vector<double>& clearances);

  [[nodiscard]] const std::optional<Dyadic>& min_eigenvalue() const { return minimum_; }

  /// @pre min_eigenvalue()
  [[nodiscard]] ProofResult proof_result(const HoldNode& node) const;
  /// @return the reason if it is not proved @pre min_eigenvalue()
  [[nodiscard]] std::optional<std::string> refusal(const HoldState& state) const;

  /// Reason why the nodes of a tree do not cover all sign patterns; nothing if they do.
  [[nodiscard]] std::optional<std::string> flaw(std::size_t tree) const;

  /// @param trees that are proved, with all of their nodes @param states likewise
  [[nodiscard]] HoldClaims claims(const std::vector<bool>& trees,
                                  const std::vector<bool>& states) const;

 private:
  /// A block to be held: which parts of the loads act on it.
  struct Part {
    bool unconstrained = false;
    bool dead = false;  ///< the dead load or a clearance
    bool reference = false;
  };
  [[nodiscard]] std::optional<std::string> refusal_of_unbalanced(LoadShare share) const;
  [[nodiscard]] std::optional<FactorRange> excluded(const HoldTree& tree) const;
  [[nodiscard]] std::vector<FactorRange> held_by(std::size_t block,
                                                 const std::vector<bool>& states) const;
  [[nodiscard]] bool out_of_equilibrium() const;
  [[nodiscard]] GripRange grip_of(std::size_t block, const std::vector<bool>& trees,
                                  const std::vector<bool>& states) const;
  [[nodiscard]] std::optional<GripRange> whole_grip(const std::vector<bool>& trees,
                                                    const std::vector<bool>& states) const;

  const HoldCertificate& certificate_;
  std::vector<BlockProof> blocks_;
  std::vector<Part> parts_;
  std::vector<Rationals> work_on_other_modes_;  // of each load: modes that displace no candidate
  std::vector<double> sizes_of_work_;           // of the dead load, from the magnitudes
  std::optional<Dyadic> minimum_;
};

/// The common parts of two lists of ranges in ascending order.
std::vector<FactorRange> common(const std::vector<FactorRange>& one,
                                const std::vector<FactorRange>& other);

/// The ranges in ascending order, those that overlap joined.
std::vector<FactorRange> joined(std::vector<FactorRange> ranges);

}  // namespace kusabi::verify
