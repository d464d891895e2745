// The motions of a body that nothing holds, as a node program takes them: with u = F r + G alpha
// and G'r = 0 (docs/theory/wedged.md, "Loose bodies").
//
// Motions that lift some candidate off its surface or press it in move u_n, and their share alpha
// is an unknown of the program. Motions along all surfaces, such as that of a block between
// parallel walls, only ask for equilibrium. So the motions are combined such that the latter come
// last and have no normal part at all.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>

#include "support/numbers/precise.hpp"

namespace kusabi::conic {

/// A motion that is normal to no surface by more than this part of the largest motion slides along
/// all of them: directions are written with sixteen digits, and places rounded to them.
inline constexpr double sliding = 1e-12;

template <class Real>
struct Motions {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

  /// G T: the displacements of the cones, D rows each, for each of p motions.
  Matrix at_cones;
  /// T, p x p, regular.
  Matrix combination;
  /// How many motions, the first ones, have a normal part.
  int lifting = 0;
  /// What an entry of `at_cones` may be wrong by.
  double error = 0;

  [[nodiscard]] int count() const { return static_cast<int>(at_cones.cols()); }

  template <class Other>
  [[nodiscard]] Motions<Other> cast(double rounding) const {
    return {at_cones.template cast<Other>(), combination.template cast<Other>(), lifting,
            error + rounding};
  }
};

/// What an elimination did.
struct Elimination {
  Eigen::Index pivots = 0;
  double growth = 1;  ///< the largest sum of sizes in a column of `combination` on the way
};

/// Combines columns with complete pivoting in every stride-th row, until what is left of these rows
/// is negligible beside the largest pivot.
/// @param columns E, changed to E T  @param combination T, identity at first
template <class Matrix>
Elimination eliminate(Matrix& columns, Matrix& combination, Eigen::Index stride,
                      double negligible) {
  Elimination result;
  const auto size = [&](Eigen::Index row, Eigen::Index column) {
    return std::abs(numbers::rounded(columns(row, column)));
  };
  double largest = 0;
  for (Eigen::Index& done = result.pivots; done < columns.cols(); ++done) {
    Eigen::Index row = 0, column = done;
    for (Eigen::Index j = done; j < columns.cols(); ++j)
      for (Eigen::Index i = 0; i < columns.rows(); i += stride)
        if (size(i, j) > size(row, column)) row = i, column = j;
    if (columns.rows() == 0 || size(row, column) <= negligible * largest) break;
    largest = std::max(largest, size(row, column));
    columns.col(done).swap(columns.col(column));
    combination.col(done).swap(combination.col(column));
    for (Eigen::Index j = done + 1; j < columns.cols(); ++j) {
      const typename Matrix::Scalar share = columns(row, j) / columns(row, done);
      columns.col(j) -= share * columns.col(done);
      combination.col(j) -= share * combination.col(done);
      result.growth =
          std::max(result.growth, combination.col(j).template cast<double>().template lpNorm<1>());
      columns(row, j) = typename Matrix::Scalar(0);
    }
  }
  return result;
}

/// Combines motions such that those without a normal part come last.
/// @param motions G, D rows a cone; entries of at most about 1
/// @param error what an entry may be wrong by
template <int D, class Real>
Motions<Real> ordered_motions(typename Motions<Real>::Matrix motions, double error) {
  const Eigen::Index p = motions.cols();
  Motions<Real> result;
  result.combination = Motions<Real>::Matrix::Identity(p, p);
  const auto [lifting, growth] = eliminate(motions, result.combination, D, sliding);
  result.lifting = static_cast<int>(lifting);
  for (Eigen::Index j = result.lifting; j < p; ++j)
    for (Eigen::Index i = 0; i < motions.rows(); i += D) motions(i, j) = Real(0);
  result.at_cones = std::move(motions);
  result.error = growth * (error + 8 * static_cast<double>(p) * numbers::unit_roundoff<Real>);
  return result;
}

}  // namespace kusabi::conic
