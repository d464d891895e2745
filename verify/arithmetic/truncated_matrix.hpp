// Exact matrix truncated to machine words, with a bound of the truncation error. Products take a
// tenth of the time of exact ones and are accurate enough for most proofs; the others use the exact
// matrix.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "verify/arithmetic/exact.hpp"

namespace kusabi::verify {

class TruncatedMatrix {
 public:
  explicit TruncatedMatrix(const DyadicMatrix& matrix);

  /// Upper bound of the Frobenius norm of the truncated part.
  [[nodiscard]] const Dyadic& cut_off() const { return cut_off_; }

  /// The exact product of the truncated matrix with a vector; nothing if a number does not fit.
  /// @pre x.size() is that of the matrix
  [[nodiscard]] std::optional<DyadicList> operator*(const DyadicList& x) const;

 private:
  std::size_t size_;
  std::vector<std::int64_t> entries_;  // by rows; empty: the matrix is too large
  long exponent_ = 0;
  Dyadic cut_off_;
};

}  // namespace kusabi::verify
