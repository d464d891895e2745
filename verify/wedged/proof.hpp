// Proofs of the claims of a certificate in exact arithmetic. docs/theory/proofs.md derives them
// with the same letters. They depend neither on the solver nor on any result of it.
#pragma once

#include <cstddef>
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
  Proof(const Certificate& certificate, const EnclosedMatrix& stiffness,
        const ContactMotions& motions = {});

  /// A proved lower bound s > 0 of the least eigenvalue of K, with a spring for each rigid-body
  /// mode; nothing if K was not proved to be positive definite up to these. Nothing else can be
  /// proved then.
  [[nodiscard]] const std::optional<Dyadic>& min_eigenvalue() const { return minimum_; }

  /// Proves a bound with those added before, and adds it for all later proofs.
  /// @return the reason if it is not proved
  /// @param bound with as many numbers as its claim requires, its candidate in its block
  /// @pre min_eigenvalue()
  [[nodiscard]] std::optional<std::string> add_bound(const CandidateBound& bound);

  /// Checks the claim on a node. A node without a claim is not refused.
  /// @pre min_eigenvalue()
  [[nodiscard]] ProofResult proof_result(const Record& record) const;

 private:
  const Certificate& certificate_;
  std::vector<BlockProof> blocks_;
  std::optional<Dyadic> minimum_;
};

/// The problem of a block.
/// @param loads of the structure, in their order; none: no states under load are proved
ContactBlock contact_block(const Certificate& certificate, const EnclosedMatrix& stiffness,
                           const ContactMotions& motions, const support::IndexSet& block,
                           const std::vector<EnclosedLoad>& loads = {});

/// A set of candidates in the numbering of a block.
support::IndexSet within(const support::IndexSet& block, const support::IndexSet& set);

/// K of the doubles of a certificate; with rigid-body modes, P'K P with the orthogonal projection P
/// onto their complement.
EnclosedMatrix recorded_stiffness(const Certificate& certificate);

}  // namespace kusabi::verify
