// The verifier's own test of evidence, as a search meets it: what `kusabi verify --problem` would
// say of a certificate with these nodes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

#include "nodes/wedged/tree/candidate_bounds.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "support/stop.hpp"
#include "verify/structure/loose_stiffness.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::wedged {

/// Most displacements, supported ones included, of a structure whose K is enclosed unasked: a
/// second.
inline constexpr int most_enclosed_displacements = 2000;

/// K of the structure with a proved bound and the motions of its loose bodies, computed by the
/// verifier; or why not, a sentence.
/// @throws support::Stopped if an end is asked for
std::variant<verify::EnclosedProblem, std::string> enclosed_stiffness(
    const problems::Structure& structure, const support::LongWork& work = {});

/// The same of a structure of any size.
std::variant<verify::EnclosedProblem, std::string> enclosed_stiffness_of_any(
    const problems::Structure& structure, const support::LongWork& work = {});

/// Whether a proof counts that leaves out configurations which move far
/// (verify/wedged/block_proof.hpp). Where levers are long, those do that turn a little.
enum class FarMotion { left_out, counted };

class EvidenceCheck {
 public:
  /// Begins with the proof that K is positive definite but for the motions.
  /// @param friction of each candidate  @param bounds of candidates; one that does not
  /// stand the test is not used, nor those after it
  EvidenceCheck(const problems::WedgedProblem& problem, const verify::EnclosedProblem& enclosed,
                std::span<const double> friction, std::span<const ProvedBound> bounds = {},
                FarMotion far_motion = FarMotion::left_out);
  EvidenceCheck(const EvidenceCheck&) = delete;
  EvidenceCheck& operator=(const EvidenceCheck&) = delete;

  /// Whether K was proved to be positive definite but for the motions: without that nothing holds.
  [[nodiscard]] bool is_able() const { return proof_->least_eigenvalue().has_value(); }

  /// Whether the evidence proves what it claims. Where nothing is claimed of a node: whether a
  /// contact without a reaction shows that all its configurations are those of others.
  [[nodiscard]] bool holds(const Evidence& evidence) const;

 private:
  FarMotion far_motion_;
  verify::Certificate certificate_;
  std::optional<verify::Proof> proof_;
};

}  // namespace kusabi::wedged
