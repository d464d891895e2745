// Stiffness regularised by grounding springs and proved to be positive definite, with approximate
// solutions in double precision that are refined by exact residuals. A small K for which doubles
// prove nothing is factorised in intervals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verify/arithmetic/cholesky.hpp"
#include "verify/arithmetic/enclosed_factor.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/arithmetic/truncated_matrix.hpp"

namespace kusabi::verify {

/// Approximate columns of an inverse on a common grid: entry (i, k) is words[count k + i] *
/// 2^exponent, where count is the number of rows.
struct InverseColumns {
  std::vector<std::int64_t> words;
  long exponent = 0;
  Dyadic error;  ///< upper bound of the Frobenius norm of their error
};

class RegularisedStiffness {
 public:
  /// @param springs displacements with a grounding spring, about as stiff as K is there
  RegularisedStiffness(EnclosedMatrix stiffness, std::vector<std::size_t> springs);

  /// A lower bound s > 0 of the least eigenvalue of every regularised K; nothing if none was
  /// proved.
  [[nodiscard]] const std::optional<Dyadic>& min_eigenvalue() const { return minimum_; }

  /// Displacements with springs, in increasing order.
  [[nodiscard]] const std::vector<std::size_t>& springs() const { return springs_; }

  /// Upper bound of the Frobenius norm of every regularised K.
  [[nodiscard]] const Dyadic& norm() const { return size_; }

  /// Checks an approximate solution x, given a product K x and a bound `off` of its error for all K
  /// within the enclosure. @return the fault; nothing if x is accurate enough for the proof
  using Check = std::function<std::optional<std::string>(const DyadicList& x, const DyadicList& kx,
                                                         const Dyadic& off)>;

  /// Solves K x = right in the rows of the unknowns, all other numbers of x being zero. The first
  /// approximation is checked with a coarse K. Each refinement adds digits, as many as a badly
  /// scaled K requires.
  /// @return the fault that the last check found, or the reason why there is no approximation
  [[nodiscard]] std::optional<std::string> solve(std::span<const std::size_t> unknowns,
                                                 const DyadicList& right, const Check& check) const;

  /// Columns of the inverse of every regularised K, with words of some 56 bits.
  /// @return nothing if there is no approximation @pre min_eigenvalue()
  [[nodiscard]] std::optional<InverseColumns> inverse_columns(
      std::span<const std::size_t> columns) const;

 private:
  // Bound of the error of K x caused by the radius of the enclosure of K.
  [[nodiscard]] static Dyadic spread(const Dyadic& radius, const DyadicList& x);
  [[nodiscard]] std::optional<Cholesky> factor(std::span<const std::size_t> unknowns) const;
  // solve() by interval arithmetic.
  [[nodiscard]] std::optional<std::string> solve_enclosed(std::span<const std::size_t> unknowns,
                                                          const DyadicList& right,
                                                          const Check& check) const;

  EnclosedMatrix stiffness_;
  TruncatedMatrix coarse_;
  std::vector<std::size_t> springs_;
  std::vector<double> rounded_;  // the middle of the enclosure, for approximate solutions
  std::optional<Dyadic> minimum_;
  Dyadic size_;
  std::optional<Cholesky> whole_;           // of all unknowns, which most solutions have
  std::optional<EnclosedFactor> enclosed_;  // the same, if doubles do not prove that K is definite
};

/// Upper bound of the Euclidean norm of a list.
Dyadic norm_above(const DyadicList& list);

/// 0, 1, ..., count - 1.
std::vector<std::size_t> first_numbers(std::size_t count);

}  // namespace kusabi::verify
