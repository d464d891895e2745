// A Cholesky factor in plain double precision, to guess with: whatever comes out is checked exactly
// (verify/wedged/proof.hpp), so it may be as wrong as it likes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "verify/arithmetic/exact.hpp"
#include "verify/arithmetic/profile.hpp"

namespace kusabi::verify {

class Cholesky {
 public:
  /// The factor L of A - shift I = L L'. @return nothing if a pivot is not positive
  /// @param matrix A, symmetric: the entries of its profile
  static std::optional<Cholesky> of(const Profile& profile, std::span<const double> matrix,
                                    double shift = 0);

  /// The solution x of L L' x = right, in the place of `right`.
  void solve(std::span<double> right) const;

  /// L: the entries of the profile.
  [[nodiscard]] std::span<const double> lower() const { return lower_; }

 private:
  Profile profile_;
  std::vector<double> lower_;
};

/// A lower bound s > 0 of the least eigenvalue of a symmetric matrix, proved:
/// docs/theory/proofs.md, "K is positive definite". @return nothing if it is not definite, or too
/// near to it to be shown so by doubles
/// @param matrix the entries of its profile
std::optional<Dyadic> least_eigenvalue(const Profile& profile, const DyadicList& matrix);

}  // namespace kusabi::verify
