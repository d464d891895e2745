// Proofs of the claims of a certificate in exact arithmetic. docs/theory/proofs.md derives them
// with the same letters. They depend neither on the solver nor on any result of it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "verify/arithmetic/exact.hpp"
#include "verify/structure/enclosed_problem.hpp"
#include "verify/wedged/block_proof.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

class Proof {
 public:
  /// Proves that K of the certificate is positive definite up to its rigid-body modes.
  /// @pre the certificate outlives this object
  explicit Proof(const Certificate& certificate);

  /// The same for every K within `stiffness` instead of the certificate's. K must be zero exactly
  /// between the blocks of the certificate.
  /// @param motions G with K G = 0, modes of unconstrained bodies: as many as the certificate has,
  ///        each in one block
  /// @param loads dead and reference, if the certificate has any; none: nothing is proved of states
  ///        under load
  Proof(const Certificate& certificate, const EnclosedMatrix& stiffness,
        const ContactMotions& motions = {}, const std::vector<EnclosedLoad>& loads = {});

  /// A proved lower bound s > 0 of the least eigenvalue of K, with a spring for each rigid-body
  /// mode; nothing if K was not proved to be positive definite up to these. Nothing else can be
  /// proved then.
  [[nodiscard]] const std::optional<Dyadic>& min_eigenvalue() const { return minimum_; }

  /// Proves a bound with those of its theorem added before, and adds it for all later proofs.
  /// @return the reason if it is not proved
  /// @param bound with as many numbers as its claim requires, its candidate in its block
  /// @pre min_eigenvalue()
  [[nodiscard]] std::optional<std::string> add_bound(const CandidateBound& bound);

  /// Checks the claim on a node. A node without a claim is not refused.
  /// @pre min_eigenvalue()
  [[nodiscard]] ProofResult proof_result(const Node& node) const;

  /// Checks a state. @return the reason if it is not proved
  /// @param grip the bounds are set; null: none are requested
  /// @pre min_eigenvalue()
  [[nodiscard]] std::optional<std::string> refusal(const State& state, Grip* grip = nullptr) const;

  /// True if the reactions of a wedged configuration resist every rigid-body mode of its block, so
  /// that it holds every load. @pre the state is proved
  [[nodiscard]] bool holds_every_load(const State& state) const;

  /// True if a rigid-body motion closes all gaps of any state of a block with these contacts exactly,
  /// without a change of its reactions, so that every candidate of the block touches.
  [[nodiscard]] bool closes_gaps(std::size_t block, const support::IndexSet& contact) const;

  /// Actions on a block, by the connections of the structure.
  struct Actions {
    bool unconstrained = false;
    bool dead = false;  ///< the dead load or a clearance
    bool reference = false;
  };
  /// By block. @pre loads
  [[nodiscard]] const std::vector<Actions>& actions() const { return actions_; }

  /// Work of the dead and of the reference load. @pre loads
  [[nodiscard]] const std::vector<LoadWork>& work() const { return work_; }

 private:
  [[nodiscard]] bool is_unbalanced(LoadShare share) const;

  const Certificate& certificate_;
  std::vector<BlockProof> blocks_;
  std::map<std::size_t, ProvedBounds> bounds_;  // by theorem
  std::vector<Actions> actions_;
  std::vector<LoadWork> work_;
  std::optional<Dyadic> minimum_;
};

/// The recorded loads, dead and reference, whose numbers are exact; none if the certificate has none.
std::vector<EnclosedLoad> recorded_loads(const Certificate& certificate);

/// K of the doubles of a certificate; with rigid-body modes, P'K P with the orthogonal projection P
/// onto their complement.
EnclosedMatrix recorded_stiffness(const Certificate& certificate);

}  // namespace kusabi::verify
