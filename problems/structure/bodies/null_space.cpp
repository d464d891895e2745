// Gauss-Jordan elimination with full pivoting.
#include "problems/structure/bodies/null_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace kusabi::problems {

using numbers::Precise;
using numbers::PreciseMatrix;
using numbers::PreciseVector;

namespace {

struct Place {
  Eigen::Index row;
  Eigen::Index column;
};

/// The largest entry, starting from a row and a column.
Place largest(const PreciseMatrix& matrix, Eigen::Index row, Eigen::Index column) {
  Place place{row, column};
  const Eigen::MatrixXd sizes = matrix.cast<double>().cwiseAbs();
  for (Eigen::Index j = column; j < matrix.cols(); ++j) {
    for (Eigen::Index i = row; i < matrix.rows(); ++i) {
      if (sizes(i, j) > sizes(place.row, place.column)) place = {i, j};
    }
  }
  return place;
}

/// The first entry, row by row, that is at least half of the largest: x before y before z.
Place first_large(const PreciseMatrix& matrix) {
  const Eigen::MatrixXd sizes = matrix.cast<double>().cwiseAbs();
  const double minimum = sizes.size() == 0 ? 0 : sizes.maxCoeff() / 2;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      if (sizes(i, j) >= minimum) return {i, j};
    }
  }
  return {0, 0};
}

/// True if the elimination continues with a pivot.
/// @return nothing if numerically undecided
std::optional<bool> continues(double pivot) {
  if (pivot <= largest_zero_pivot) return false;
  if (pivot >= smallest_nonzero_pivot) return true;
  return {};
}

}  // namespace

NullSpace null_space(PreciseMatrix matrix) {
  const Eigen::Index q = matrix.cols();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(q));
  for (Eigen::Index k = 0; k < q; ++k) order[static_cast<std::size_t>(k)] = k;
  NullSpace result;
  Eigen::Index rank = 0;
  for (; rank < std::min(q, matrix.rows()); ++rank) {
    const auto [row, column] = largest(matrix, rank, rank);
    const double pivot = std::abs(numbers::rounded(matrix(row, column)));
    const auto more = continues(pivot);
    if (!more) return {PreciseMatrix(q, 0), 0};
    if (!*more) break;
    result.min_pivot = std::min(result.min_pivot, pivot);
    matrix.row(row).swap(matrix.row(rank));
    matrix.col(column).swap(matrix.col(rank));
    std::swap(order[static_cast<std::size_t>(column)], order[static_cast<std::size_t>(rank)]);
    const PreciseVector own = matrix.row(rank).transpose() / matrix(rank, rank);
    matrix.row(rank) = own.transpose();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      if (i == rank || matrix(i, rank).is_zero()) continue;
      const Precise factor = matrix(i, rank);
      for (Eigen::Index j = rank; j < q; ++j) matrix(i, j) -= factor * own(j);
    }
  }
  result.columns = PreciseMatrix::Zero(q, q - rank);
  for (Eigen::Index free = rank; free < q; ++free) {
    result.columns(order[static_cast<std::size_t>(free)], free - rank) = 1.0;
    for (Eigen::Index i = 0; i < rank; ++i)
      result.columns(order[static_cast<std::size_t>(i)], free - rank) = -matrix(i, free);
  }
  return result;
}

std::optional<std::pair<Eigen::Index, double>> echelon(PreciseMatrix& columns,
                                                       Eigen::Index first_row, Eigen::Index rows) {
  Eigen::Index left = columns.cols();  // columns [left, end) are done
  double minimum = 1;
  while (left > 0) {
    const PreciseMatrix part = columns.block(first_row, 0, rows, left);
    const auto [row, column] = first_large(part);
    const double pivot = std::abs(numbers::rounded(part(row, column)));
    const auto more = continues(pivot);
    if (!more) return {};
    if (!*more) break;
    minimum = std::min(minimum, pivot);
    --left;
    columns.col(column).swap(columns.col(left));
    const PreciseVector own = columns.col(left) / columns(first_row + row, left);
    columns.col(left) = own;
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
      if (j == left) continue;
      const Precise factor = columns(first_row + row, j);
      if (!factor.is_zero()) columns.col(j) -= factor * own;
    }
  }
  // The eliminated entries are zero.
  columns.block(first_row, 0, rows, left).setConstant(Precise(0.0));
  const PreciseMatrix done = columns.rightCols(columns.cols() - left);
  columns.rightCols(done.cols()) = done.rowwise().reverse();  // the first pivot first
  return std::pair(done.cols(), minimum);
}

}  // namespace kusabi::problems
