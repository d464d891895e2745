// Motions: rigid-body modes of an unconstrained body in a node program: u = F r + G alpha and G'r =
// 0 (docs/theory/wedged.md, "Unconstrained bodies").
//
// Modes that separate or press in a candidate change u_n, and their coefficients alpha are unknowns
// of the program. Modes that slide along all surfaces, such as that of a block between parallel
// walls, add equations of equilibrium only. The modes are combined such that the latter come last
// and have no normal part.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>

#include "support/numbers/precise.hpp"

namespace kusabi::conic {

template <class Real>
using VectorOf = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
template <class Real>
using MatrixOf = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Threshold of the normal part, relative to the largest component, below which a mode slides along
/// all surfaces: directions are written with sixteen digits, and positions are rounded to them.
inline constexpr double sliding = 1e-12;

/// Threshold, relative to the largest mode, below which a mode does not displace the cones or rows
/// of a node, up to the rounding of positions and directions in the file.
inline constexpr double negligible_mode = 1e-10;

/// A last column of G that is an equation for the reactions alone, with normal parts. A correction
/// of normal displacements by normal forces changes it: by a negligible amount, or so that the last
/// load, its slack, takes the change up.
enum class SideEquation { none, exact, with_slack };

template <class Real>
struct Motions {
  using Matrix = MatrixOf<Real>;

  /// G T: the displacements of the cones, D rows each, for each of p modes.
  Matrix at_cones;
  /// T, p x p, regular.
  Matrix combination;
  /// Number of modes with a normal part; these come first.
  int lifting = 0;
  SideEquation equation = SideEquation::none;
  /// Error bound of an entry of `at_cones`.
  double error = 0;

  [[nodiscard]] int count() const { return static_cast<int>(at_cones.cols()); }

  template <class Other>
  [[nodiscard]] Motions<Other> cast(double rounding) const {
    return {at_cones.template cast<Other>(), combination.template cast<Other>(), lifting, equation,
            error + rounding};
  }
};

/// Result of an elimination.
struct EliminationResult {
  Eigen::Index pivots = 0;
  /// the largest sum of magnitudes in a column of `combination` during the elimination
  double growth = 1;
};

/// Combines columns by elimination with complete pivoting in every stride-th row, until the
/// remainder of these rows is negligible relative to the largest pivot or to `largest`.
/// @param columns E, replaced by E T  @param combination T, initially the identity
/// @param largest largest component of the columns, also in rows that are not in E
/// @param without number of last rows without pivots
template <class Matrix>
EliminationResult eliminate(Matrix& columns, Matrix& combination, Eigen::Index stride,
                            double negligible, double largest = 0, Eigen::Index without = 0) {
  const Eigen::Index height = columns.rows() - without;
  EliminationResult result;
  const auto size = [&](Eigen::Index row, Eigen::Index column) {
    return std::abs(numbers::rounded(columns(row, column)));
  };
  for (Eigen::Index& done = result.pivots; done < columns.cols(); ++done) {
    Eigen::Index row = 0, column = done;
    for (Eigen::Index j = done; j < columns.cols(); ++j)
      for (Eigen::Index i = 0; i < height; i += stride)
        if (size(i, j) > size(row, column)) row = i, column = j;
    if (height == 0 || size(row, column) <= negligible * largest) break;
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

/// Size of the largest displacement of a candidate by the columns of G.
/// @param loads number of last rows that are none
template <class Matrix>
double largest_displacement(const Matrix& motions, Eigen::Index loads) {
  const auto own = motions.topRows(motions.rows() - loads);
  if (own.size() == 0) return 0;
  return numbers::rounded(typename Matrix::Scalar(own.cwiseAbs().maxCoeff()));
}

/// Combines modes such that those without a normal part come last.
/// @param motions G, D rows per cone; entries of at most about 1
/// @param error error bound of an entry
/// @param loads number of loads, whose cones are the last and have no displacement
/// @param equation of the last column, whose normal rows are kept
template <int D, class Real>
Motions<Real> ordered_motions(typename Motions<Real>::Matrix motions, double error, int loads = 0,
                              SideEquation equation = SideEquation::none) {
  using Matrix = typename Motions<Real>::Matrix;
  if (equation != SideEquation::none) {
    const Eigen::Index own = motions.cols() - 1;
    auto result = ordered_motions<D, Real>(Matrix(motions.leftCols(own)), error, loads);
    Matrix combination = Matrix::Identity(motions.cols(), motions.cols());
    combination.topLeftCorner(own, own) = result.combination;
    motions.leftCols(own) = result.at_cones;
    result.combination = std::move(combination);
    result.at_cones = std::move(motions);
    result.error = std::max(result.error, error);
    result.equation = equation;
    return result;
  }
  const Eigen::Index p = motions.cols();
  Motions<Real> result;
  result.combination = Matrix::Identity(p, p);
  const Eigen::Index without = Eigen::Index{D} * loads;
  const auto [lifting, growth] = eliminate(motions, result.combination, D, sliding,
                                           largest_displacement(motions, without), without);
  result.lifting = static_cast<int>(lifting);
  for (Eigen::Index j = result.lifting; j < p; ++j)
    for (Eigen::Index i = 0; i < motions.rows() - without; i += D) motions(i, j) = Real(0);
  result.at_cones = std::move(motions);
  result.error = growth * (error + 8 * static_cast<double>(p) * numbers::unit_roundoff<Real>);
  return result;
}

}  // namespace kusabi::conic
