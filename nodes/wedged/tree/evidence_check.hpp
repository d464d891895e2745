// Exact test of evidence during a search, by the proofs that `kusabi verify --problem` applies to a
// certificate with these nodes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "nodes/wedged/relaxation/candidate_bounds.hpp"
#include "nodes/wedged/tree/evidence.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "support/stop.hpp"
#include "verify/structure/enclosed_problem.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::wedged {

/// Maximum number of displacements, including supported ones, of a structure whose K is enclosed by
/// default: it takes about a second.
inline constexpr int max_enclosed_displacements = 2000;

/// Largest scale ratio of a structure for which the tolerances 1e-10 and 1e-12, relative to the
/// largest number, are safe. Above it numbers below these may be significant.
inline constexpr double max_safe_scale_ratio = 1e7;

/// Threshold of |t*| above which its sign is used with the exact test, although it is zero in
/// sixteen digits.
inline constexpr double exact_test_resolution = 1e-22;

/// K of the structure with a proved bound and the modes of its unconstrained bodies, computed by
/// the verifier; otherwise a sentence with the reason.
/// @throws support::Stopped if the program is asked to stop
std::variant<verify::EnclosedProblem, std::string> enclosed_stiffness(
    const problems::Structure& structure, const support::LongWork& work = {});

/// The same for a structure of any size.
std::variant<verify::EnclosedProblem, std::string> enclosed_stiffness_without_limit(
    const problems::Structure& structure, const support::LongWork& work = {});

/// The problem of a certificate with one theorem about the wedged configurations of each block;
/// without friction, K and loads.
verify::Certificate header_of(const problems::WedgedProblem& problem);

/// A bound as one of a certificate.
verify::CandidateBound verified(const ProvedBound& bound, std::size_t theorem);

/// Treatment of proofs that do not cover large displacements (verify/wedged/block_model.hpp). In
/// structures with long levers, small rotations cause such displacements.
enum class LargeDisplacements { left_out, counted };

/// Exact test of evidence for one friction coefficient of each candidate.
class EvidenceCheck {
 public:
  /// Proves that K is positive definite up to rigid-body modes.
  /// @param friction of each candidate
  /// @param bounds of candidates; the first one that is not proved and all later ones are not used
  EvidenceCheck(const problems::WedgedProblem& problem, const verify::EnclosedProblem& enclosed,
                std::span<const double> friction, std::span<const ProvedBound> bounds = {},
                LargeDisplacements large_displacements = LargeDisplacements::left_out);
  EvidenceCheck(const EvidenceCheck&) = delete;
  EvidenceCheck& operator=(const EvidenceCheck&) = delete;

  /// True if K was proved to be positive definite up to rigid-body modes; without it nothing can be
  /// proved.
  [[nodiscard]] bool can_prove() const { return proof_->min_eigenvalue().has_value(); }

  /// True if every bound is proved.
  [[nodiscard]] bool proves_bounds() const { return proves_bounds_; }

  /// True if the evidence proves its claim. For a node without claim: true if a contact without
  /// reaction proves that all its configurations belong to other nodes.
  [[nodiscard]] bool holds(const Evidence& evidence) const {
    return proof(evidence) != NodeProof::refused;
  }

  /// The same, with the extent of the proof.
  [[nodiscard]] NodeProof proof(const Evidence& evidence) const;

 private:
  LargeDisplacements large_displacements_;
  verify::Certificate certificate_;
  std::optional<verify::Proof> proof_;
  bool proves_bounds_ = false;
};

}  // namespace kusabi::wedged
