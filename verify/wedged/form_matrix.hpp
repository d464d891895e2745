// Quadratic form of a certificate in exact arithmetic. Its unknowns are x = (r, a), reactions and
// coefficients of rigid-body motions D a, with u_n = U x, U = [F_n, D].
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "verify/arithmetic/exact.hpp"
#include "verify/arithmetic/word_grid.hpp"
#include "verify/structure/contact_motions.hpp"
#include "verify/structure/regularised_stiffness.hpp"

namespace kusabi::verify {

/// The recorded numbers of a block with m candidates.
struct FormNumbers {
  std::span<const double> products;  ///< P, m x m, by rows
  std::span<const double> slips;     ///< S, for each pair (j, k) its d - 1 components
  std::span<const double> squares;   ///< sigma, m
  std::span<const double> pairs;     ///< N, m x m, by rows; none: zero

  /// True if P_ij >= 0 for i != j, N_ij >= 0 and sigma > 0.
  [[nodiscard]] bool has_allowed_signs() const;
};

/// U, m x n by rows, and a bound of its error in the Frobenius norm.
struct NormalRows {
  WordGrid grid;
  Dyadic error;
};

/// @param inverse columns of the compliance at the normals
/// @param lifting rigid-body motions, dm displacements each; the unit of the coefficient of each is
///        a power of two for which D is as large as F
NormalRows normal_rows(const InverseColumns& inverse, const std::vector<ApproximateList>& lifting,
                       std::size_t m, std::size_t d);

/// Twice the form.
class FormMatrix {
 public:
  /// U'Q + Q'U with Q = P R + N U, R x = r_n.
  FormMatrix(const FormNumbers& form, const NormalRows& rows, std::size_t d);

  /// Adds the products of friction. @param friction upper bounds of friction coefficients, m
  void add_friction(const FormNumbers& form, std::span<const Dyadic> friction, std::size_t d);

  /// Adds G C + C'G', zero for G'r = 0, with a C, p x n, for which the part outside G'r = 0 is near
  /// -level I, without coupling to the rest.
  /// @param motions p columns of G @return false: they are dependent
  bool restrict_to_equilibrium(const std::vector<ApproximateList>& motions);

  /// A lower bound of the least eigenvalue of minus the matrix; nothing if it is not positive.
  [[nodiscard]] std::optional<Dyadic> min_opposite() const;

  /// Bound of the error of x'(matrix)x for |x| = 1.
  [[nodiscard]] const Dyadic& error() const { return error_; }

 private:
  [[nodiscard]] Dyadic& at(std::size_t i, std::size_t j) {
    return i < j ? lower_[j * (j + 1) / 2 + i] : lower_[i * (i + 1) / 2 + j];
  }
  [[nodiscard]] std::optional<std::vector<double>> equilibrium_factors(
      std::span<const double> motions, std::size_t p);

  std::vector<Dyadic> lower_;  // by rows up to the diagonal
  std::size_t size_ = 0;       // n
  Dyadic error_;
};

}  // namespace kusabi::verify
