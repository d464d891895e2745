// The proofs of one block of contact candidates: that its K is positive definite, that nothing is
// wedged below a dead node, and that a living leaf has a configuration; for every K that an
// enclosure holds. docs/theory/proofs.md has the same letters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verify/cholesky.hpp"
#include "verify/exact.hpp"

namespace kusabi::verify {

/// What is to be proved something of. Sets of candidates have bit i for candidate i of the block.
struct ContactBlock {
  std::size_t dimension = 0;       ///< d
  EnclosedMatrix stiffness;        ///< K, dm x dm
  std::vector<double> friction;    ///< mu, m, >= 0
  std::vector<std::string> names;  ///< m, for messages
};

class BlockProof {
 public:
  explicit BlockProof(ContactBlock block);

  /// A lower bound s > 0 of the least eigenvalue of every K; nothing if it was not shown.
  [[nodiscard]] const std::optional<Dyadic>& least_eigenvalue() const { return least_; }

  /// Whether nothing is wedged below the node (U, R). @return why not; nothing if it is proved
  /// @param multipliers m @pre least_eigenvalue()
  [[nodiscard]] std::optional<std::string> refusal_of_dead(
      std::uint64_t contact, std::uint64_t separated, std::span<const double> multipliers) const;

  /// Whether the leaf (U, R) has a configuration in its interior. @return why not
  /// @param tangential reactions of U, d - 1 each @pre least_eigenvalue()
  [[nodiscard]] std::optional<std::string> refusal_of_alive(
      std::uint64_t contact, std::uint64_t separated, std::span<const double> tangential) const;

 private:
  // What is wrong with a guess x, given the product of the middle of K with it; nothing if it
  // proves what it is to prove.
  using Check =
      std::function<std::optional<std::string>(const DyadicList& x, const DyadicList& kx)>;

  [[nodiscard]] std::optional<std::string> check_dead(std::uint64_t contact,
                                                      std::uint64_t separated, const DyadicList& w,
                                                      const DyadicList& nu) const;
  [[nodiscard]] std::optional<std::string> check_alive(std::uint64_t contact,
                                                       std::uint64_t separated,
                                                       const DyadicList& right, const DyadicList& u,
                                                       const DyadicList& r) const;
  [[nodiscard]] std::optional<std::string> guess(const Cholesky& factor,
                                                 std::span<const std::size_t> unknowns,
                                                 const DyadicList& right, const Check& check) const;
  [[nodiscard]] Dyadic tangential_square(const DyadicList& vector, std::size_t candidate) const;
  [[nodiscard]] Dyadic spread(const DyadicList& x) const;
  [[nodiscard]] std::size_t candidates() const { return block_.names.size(); }

  ContactBlock block_;
  std::vector<double> rounded_;     // K, to guess with
  std::vector<Dyadic> friction_;    // mu
  Dyadic steepest_;                 // the root of 1 + the largest mu^2, or more
  std::optional<Dyadic> least_;     // s
  Dyadic size_of_stiffness_;        // above the Frobenius norm of K
  std::optional<Cholesky> factor_;  // of K, to guess with
};

}  // namespace kusabi::verify
