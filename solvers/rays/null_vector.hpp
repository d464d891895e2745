// null_vector: the null vector of a matrix of known nullity one: the coordinates of a ray from its
// equalities.
//
// Gaussian elimination with full pivoting. The rank is known, one less than the number of columns,
// and all pivots but the last are used. Eigen's FullPivLU performs the same operations in the same
// order, with the same rounding, but searches each pivot in a separate pass, which for extended
// precision takes twice the time.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace kusabi::rays {

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// @param equalities k x n, k >= n - 1, of rank n - 1; rows of one unit
/// @param summed the first `summed` numbers have the sum 1; if 0, the largest number is 1
/// @return n numbers
LongVector null_vector(const LongMatrix& equalities, Eigen::Index summed);
inline LongVector null_vector(const LongMatrix& equalities) {
  return null_vector(equalities, equalities.cols());
}

/// As null_vector, to the digits of a double, at a fifth of the time: elimination in doubles, and
/// iterative refinement with residuals in extended precision. Nothing if it does not converge in a
/// few corrections.
/// @param equalities, summed as for `null_vector`  @param rounded equalities in doubles
std::optional<Eigen::VectorXd> rounded_null_vector(const LongMatrix& equalities,
                                                   const Eigen::MatrixXd& rounded,
                                                   Eigen::Index summed);
inline std::optional<Eigen::VectorXd> rounded_null_vector(const LongMatrix& equalities,
                                                          const Eigen::MatrixXd& rounded) {
  return rounded_null_vector(equalities, rounded, equalities.cols());
}

}  // namespace kusabi::rays
