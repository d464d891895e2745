// A matrix of exact numbers cut off to those that fit into a machine word: products with it take a
// tenth of the time, and it says how far they may be off. What a proof has to spare is mostly far
// more than that; the exact matrix is there for what it is not.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "verify/arithmetic/exact.hpp"

namespace kusabi::verify {

class CoarseMatrix {
 public:
  explicit CoarseMatrix(const DyadicMatrix& matrix);

  /// Not below the Frobenius norm of what was cut off.
  [[nodiscard]] const Dyadic& cut_off() const { return cut_off_; }

  /// The product of what is left with a vector, exactly; nothing if a number of it does not fit.
  /// @pre x.size() is that of the matrix
  [[nodiscard]] std::optional<DyadicList> operator*(const DyadicList& x) const;

 private:
  std::size_t size_;
  std::vector<std::int64_t> entries_;  // row by row; empty: the matrix is too large
  long exponent_ = 0;
  Dyadic cut_off_;
};

}  // namespace kusabi::verify
