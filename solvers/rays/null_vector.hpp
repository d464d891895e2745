// The null vector of a matrix that is known to have just one, up to scale: the numbers of a ray
// from its equalities.
//
// By Gaussian elimination with full pivoting. The rank is known, one less than the number of
// columns, so it is not guessed: all pivots but the last are used. Eigen's FullPivLU does the same
// operations in the same order, so with the same rounding, but looks for each pivot in a pass of
// its own, and for extended precision in twice the time.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace kusabi::rays {

/// F and A are kept with more digits than a double has: see problems/wedged/precise_compliance.hpp.
using PreciseMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using PreciseVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// @param equalities k x n, k >= n - 1, of rank n - 1; rows of one unit
/// @param summed so many numbers, the first, have the sum 1; if there are none, the largest number
///        is 1
/// @return n numbers
PreciseVector null_vector(const PreciseMatrix& equalities, Eigen::Index summed);
inline PreciseVector null_vector(const PreciseMatrix& equalities) {
  return null_vector(equalities, equalities.cols());
}

/// The same to the digits of a double, at a fifth of the time: by elimination in doubles, and
/// corrections by what the equalities leave in extended precision until they are small. Nothing if
/// they do not get small soon.
/// @param equalities, summed as for `null_vector`  @param rounded the same in doubles
std::optional<Eigen::VectorXd> rounded_null_vector(const PreciseMatrix& equalities,
                                                   const Eigen::MatrixXd& rounded,
                                                   Eigen::Index summed);
inline std::optional<Eigen::VectorXd> rounded_null_vector(const PreciseMatrix& equalities,
                                                          const Eigen::MatrixXd& rounded) {
  return rounded_null_vector(equalities, rounded, equalities.cols());
}

}  // namespace kusabi::rays
