// A stiffness with springs that hold what nothing else holds, proved to be definite; and solutions
// with it, guessed in double precision and refined with exact residuals.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verify/arithmetic/cholesky.hpp"
#include "verify/arithmetic/coarse_matrix.hpp"
#include "verify/arithmetic/exact.hpp"

namespace kusabi::verify {

class HeldStiffness {
 public:
  /// @param springs displacements of which each gets a spring, about as stiff as K is there
  HeldStiffness(EnclosedMatrix stiffness, std::vector<std::size_t> springs);

  /// A lower bound s > 0 of the least eigenvalue of every K with the springs; nothing if it was not
  /// shown.
  [[nodiscard]] const std::optional<Dyadic>& least_eigenvalue() const { return least_; }

  /// Which displacements have springs, in increasing order.
  [[nodiscard]] const std::vector<std::size_t>& springs() const { return springs_; }

  /// Above the Frobenius norm of every K with the springs.
  [[nodiscard]] const Dyadic& size() const { return size_; }

  /// What is wrong with a guess x, given a product K x and not less than what it may be off by, K
  /// being anywhere within its enclosure; nothing if it proves what it is to prove.
  using Check = std::function<std::optional<std::string>(const DyadicList& x, const DyadicList& kx,
                                                         const Dyadic& off)>;

  /// Solves for the unknowns, the others being zero: K x = right in their rows. The first guess is
  /// checked with a coarse K. Solved again for what is left, x has more digits than a double, as
  /// many as a badly scaled K needs.
  /// @return what the last check said, or why there is no guess
  [[nodiscard]] std::optional<std::string> guess(std::span<const std::size_t> unknowns,
                                                 const DyadicList& right, const Check& check) const;

 private:
  // What K x may be off by if K is so far away.
  [[nodiscard]] static Dyadic spread(const Dyadic& radius, const DyadicList& x);
  [[nodiscard]] std::optional<Cholesky> factor(std::span<const std::size_t> unknowns) const;

  EnclosedMatrix stiffness_;
  CoarseMatrix coarse_;
  std::vector<std::size_t> springs_;
  std::vector<double> rounded_;  // the middle, to guess with
  std::optional<Dyadic> least_;
  Dyadic size_;
  std::optional<Cholesky> whole_;  // of all unknowns, which most guesses have
};

/// Above the Euclidean norm of a list.
Dyadic norm_above(const DyadicList& list);

/// 0, 1, ..., count - 1.
std::vector<std::size_t> first_numbers(std::size_t count);

}  // namespace kusabi::verify
