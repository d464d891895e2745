// The proofs of a certificate, in exact arithmetic. docs/theory/proofs.md derives what is checked
// here, with the same letters; nothing of the solver is used, and nothing that it says is believed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "verify/arithmetic/exact.hpp"
#include "verify/wedged/block_proof.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

class Proof {
 public:
  /// Begins with the proof that K, that of the certificate, is positive definite but for its
  /// motions. The certificate must outlive this.
  explicit Proof(const Certificate& certificate);

  /// The same for every K that `stiffness` encloses, whatever the certificate says of it. Between
  /// the blocks of the certificate K must be known to be zero.
  /// @param motions of bodies that nothing holds, G with K G = 0: as many as the certificate has,
  ///        each of one block
  Proof(const Certificate& certificate, const EnclosedMatrix& stiffness,
        const ContactMotions& motions = {});

  /// A lower bound s > 0 of the least eigenvalue of K, with a spring for each motion, proved;
  /// nothing if K was not shown to be positive definite but for these, and then nothing else can be
  /// shown either.
  [[nodiscard]] const std::optional<Dyadic>& least_eigenvalue() const { return least_; }

  /// Proves a bound by those that were taken up before, and takes it up; or says why it does not.
  /// It holds for all judgements to come.
  /// @param bound its numbers as many as it says, the candidate one of its block
  /// @pre least_eigenvalue()
  [[nodiscard]] std::optional<std::string> take_up(const Bound& bound);

  /// Checks what is claimed of a node; where nothing is claimed, nothing is refused.
  /// @pre least_eigenvalue()
  [[nodiscard]] Judgement judgement(const Record& record) const;

 private:
  const Certificate& certificate_;
  std::vector<BlockProof> blocks_;
  std::optional<Dyadic> least_;
};

/// K of a certificate, as its doubles say; with motions, P'K P with the orthogonal projection P on
/// what is across them.
EnclosedMatrix recorded_stiffness(const Certificate& certificate);

}  // namespace kusabi::verify
