// Null space and echelon form of small matrices in 104 bits. Zeros are clearly distinguished from
// other numbers; what is between both is numerically undecided.
#pragma once

#include <optional>
#include <utility>

#include <Eigen/Core>

#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// A pivot below this is zero: exact linear dependence of coordinates leaves 1e-29.
inline constexpr double largest_zero_pivot = 1e-24;
/// A pivot above this is not zero, since rounding of the file could not cause it. Structures with
/// pivots between both are refused.
inline constexpr double smallest_nonzero_pivot = 1e-8;

/// The null space of a matrix with q columns, and its smallest pivot; no columns and a pivot of
/// zero if numerically undecided.
struct NullSpace {
  numbers::PreciseMatrix columns;
  double min_pivot = 1;
};

NullSpace null_space(numbers::PreciseMatrix matrix);

/// Combines columns such that the given rows are in echelon form.
/// @return the number of columns with entries in these rows, which come last, and the least pivot;
///   nothing if numerically undecided
std::optional<std::pair<Eigen::Index, double>> echelon(numbers::PreciseMatrix& columns,
                                                       Eigen::Index first_row, Eigen::Index rows);

}  // namespace kusabi::problems
