// Conclusions from the proved theorems and states of a certificate, by operations on sets of load
// factors and sums of normal reactions (docs/theory/proofs.md, "Conclusions"). Nothing else draws
// one.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "verify/structure/contact_motions.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/proof.hpp"

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

/// Known load factors of states; with normal reactions that add up to the total of the
/// certificate, if it has one.
struct HoldClaims {
  std::vector<FactorRange> held{};  ///< each factor has a state; in ascending order
  std::vector<FactorRange> none{};  ///< no factor has one; in ascending order
  GripRange grip{};                 ///< under the dead load
  bool restricts_a_sum = false;     ///< some theorem does
};

/// Statements of a certificate that are proved: theorems with all of their nodes and their cover.
struct Proved {
  std::vector<bool> theorems, states;
  /// Some theorem leaves out displacements over `largest_displacement_ratio` times the strains.
  bool except_large_displacements = false;
};

struct Conclusion {
  /// The list of the wedged patterns is complete, except for patterns below nodes without a claim.
  bool complete_list = false;
  std::optional<HoldClaims> loads{};  ///< if the certificate has loads
  /// Reason why nothing is concluded: nothing is stated of some block, or statements contradict
  /// each other, so that the verification itself is wrong.
  std::optional<std::string> refusal{};
};

Conclusion conclude(const Certificate& certificate, const Proof& proof, const Proved& proved);

/// Factors at which the loads do work on a motion that displaces no candidate, whatever the
/// reactions. They are in equilibrium at one other factor at most if one of them is_unbalanced().
std::vector<FactorRange> out_of_equilibrium(const LoadWork& dead, const LoadWork& reference);

/// True if one of the ranges contains all factors from `low` to `high`.
bool contains(const std::vector<FactorRange>& ranges, double low, double high);

/// The common parts of two lists of ranges in ascending order.
std::vector<FactorRange> common(const std::vector<FactorRange>& one,
                                const std::vector<FactorRange>& other);

/// The ranges in ascending order, those that overlap joined.
std::vector<FactorRange> joined(std::vector<FactorRange> ranges);

}  // namespace kusabi::verify
