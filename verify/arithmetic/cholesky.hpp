// Cholesky factor in double precision, for approximate solutions. Results are checked exactly
// (verify/wedged/proof.hpp), so the factor need not be accurate.
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
  /// @param matrix A, symmetric, as the entries of its profile
  static std::optional<Cholesky> of(const Profile& profile, std::span<const double> matrix,
                                    double shift = 0);

  /// Solves L L' x = right and overwrites `right` with x.
  void solve(std::span<double> right) const;

  /// L, as the entries of the profile.
  [[nodiscard]] std::span<const double> lower() const { return lower_; }

 private:
  Profile profile_;
  std::vector<double> lower_;
};

/// A proved lower bound s > 0 of the least eigenvalue of a symmetric matrix (docs/theory/proofs.md,
/// "K is positive definite").
/// @return nothing if the matrix is not positive definite, or too close to singular for a proof in
///   double precision
/// @param matrix the entries of its profile
std::optional<Dyadic> min_eigenvalue(const Profile& profile, const DyadicList& matrix);

}  // namespace kusabi::verify
