// Factorisation A = L D L' in interval arithmetic, for symmetric matrices that are too close to
// singular for double precision (verify/arithmetic/cholesky.hpp). It takes some hundred times as
// long.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "verify/arithmetic/enclosure.hpp"

namespace kusabi::verify {

class EnclosedFactor {
 public:
  /// @param lower the lower triangle of A with `size` rows, by rows
  /// @return nothing if a pivot is not proved to be positive
  static std::optional<EnclosedFactor> of(std::size_t size, const DyadicList& lower);

  /// The solution x of A x = right. @pre as many numbers as A has rows
  [[nodiscard]] std::vector<Enclosure> solve(std::vector<Enclosure> right) const;

  /// A lower bound of the least eigenvalue of A, 1 / trace(A^-1): at most `size` times too small.
  [[nodiscard]] Dyadic min_eigenvalue() const;

 private:
  // -L, strictly lower triangular, by rows of i numbers.
  [[nodiscard]] const Enclosure& opposite(std::size_t i, std::size_t j) const {
    return opposite_[i * (i - 1) / 2 + j];
  }

  std::vector<Enclosure> opposite_;
  std::vector<Enclosure> pivots_;  // D
};

}  // namespace kusabi::verify
