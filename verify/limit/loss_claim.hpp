// Proof of the claims on the loss of members, in exact arithmetic: each state carries the claimed
// factor, every loss misses the members of a state, and the motion after the worst loss bounds the
// factor from above.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verify/limit/exact_truss.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/loss_certificate.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// Truss of the proofs for a statement: that of a problem file, or of the certificate.
class LossClaim {
 public:
  /// @param structure of the problem file, in the load case of the statement; nothing: the claim is
  ///        about the truss of the certificate @pre the statement outlives this object
  LossClaim(const LossStatement& statement, std::optional<Structure> structure);
  LossClaim(const LossClaim&) = delete;
  LossClaim& operator=(const LossClaim&) = delete;
  ~LossClaim() = default;

  /// The difference of the certificate from the problem file; nothing: there is none.
  [[nodiscard]] const std::optional<std::string>& difference() const { return difference_; }

  /// Name, or nothing, and half-width of each uncertain load. @pre no difference
  [[nodiscard]] std::vector<std::pair<std::string, double>> half_widths() const;

  /// Everything except the states. @return refusals
  /// @param upper upper bound of the factor, minus infinity after a fatal loss
  [[nodiscard]] std::vector<std::string> check_loss(double& upper) const;

  /// The reason why a state does not carry the claimed factor; nothing: it does.
  [[nodiscard]] std::optional<std::string> refusal_of_state(std::size_t number) const;

 private:
  // Quotients of yield forces and dynamic factor are rounded to the safe side of either bound.
  void divide_yield_forces(const std::vector<Bar>& bars);

  const LossStatement& statement_;
  LimitCertificate evidence_;                  // of the truss before the loss
  std::vector<double> tension_, compression_;  // rounded up, for the upper bound
  std::optional<LimitTruss> truss_;
  std::optional<LimitProof> proof_;  // of evidence_; nothing: a difference
  ExactTruss exact_;
  std::vector<std::string> names_;       // of the members
  std::vector<std::string> load_names_;  // of the uncertain loads; empty: unnamed
  std::optional<std::string> difference_;
};

/// The loads, yield forces and direction cosines of a truss as doubles, without evidence.
LimitCertificate recorded_loads(const Structure& truss);

}  // namespace kusabi::verify
