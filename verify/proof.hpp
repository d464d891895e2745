// The proofs of a certificate, in exact arithmetic. docs/theory.md, section 4, derives what is
// checked here, with the same letters; nothing of the solver is used, and nothing that it says is
// believed.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verify/certificate.hpp"
#include "verify/cholesky.hpp"
#include "verify/exact.hpp"

namespace kusabi::verify {

class Proof {
 public:
  /// Begins with the proof that K is positive definite. The certificate must outlive this.
  explicit Proof(const Certificate& certificate);

  /// A lower bound s > 0 of the least eigenvalue of K, proved; nothing if K was not shown to be
  /// positive definite, and then nothing else can be shown either.
  [[nodiscard]] const std::optional<Dyadic>& least_eigenvalue() const { return least_; }

  /// Checks what is claimed of a node. @return why it is not proved; nothing if it is, or if
  /// nothing is claimed
  /// @pre least_eigenvalue()
  [[nodiscard]] std::optional<std::string> refusal(const Record& record) const;

 private:
  // What is wrong with a guess x, given K x as well; nothing if it proves what it is to prove.
  using Check =
      std::function<std::optional<std::string>(const DyadicList& x, const DyadicList& kx)>;

  [[nodiscard]] std::optional<std::string> refusal_of_dead(const Record& record) const;
  [[nodiscard]] std::optional<std::string> refusal_of_alive(const Record& record) const;
  [[nodiscard]] std::optional<std::string> check_dead(const Record& record, const DyadicList& w,
                                                      const DyadicList& nu) const;
  [[nodiscard]] std::optional<std::string> check_alive(const Record& record,
                                                       const DyadicList& right, const DyadicList& u,
                                                       const DyadicList& r) const;
  [[nodiscard]] std::optional<std::string> guess(const Cholesky& factor,
                                                 std::span<const std::size_t> unknowns,
                                                 const DyadicList& right, const Check& check) const;
  [[nodiscard]] std::optional<Dyadic> bound_of_eigenvalues() const;
  [[nodiscard]] Dyadic tangential_square(const DyadicList& vector, std::size_t candidate) const;

  const Certificate& certificate_;
  DyadicMatrix stiffness_;          // K
  std::vector<Dyadic> friction_;    // mu
  Dyadic steepest_;                 // 1 + the largest mu^2
  std::optional<Dyadic> least_;     // s
  Dyadic size_of_stiffness_;        // above the Frobenius norm of K
  std::optional<Cholesky> factor_;  // of K, to guess with
};

}  // namespace kusabi::verify
