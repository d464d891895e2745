// A Cholesky factor in plain double precision, to guess with: whatever comes out is checked exactly
// (verify/proof.hpp), so it may be as wrong as it likes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace kusabi::verify {

class Cholesky {
 public:
  /// The factor L of A - shift I = L L'. @return nothing if a pivot is not positive
  /// @param matrix A, symmetric, row by row
  static std::optional<Cholesky> of(std::span<const double> matrix, std::size_t size,
                                    double shift = 0);

  /// The solution x of L L' x = right, in the place of `right`.
  void solve(std::span<double> right) const;

  /// L, row by row, zeros above its diagonal.
  [[nodiscard]] std::span<const double> lower() const { return lower_; }

 private:
  std::size_t size_ = 0;
  std::vector<double> lower_;
};

}  // namespace kusabi::verify
