// Exact products of doubles by splitting (Dekker 1971), sums of two doubles with their error
// (Knuth), as in the QD library (Hida, Li and Bailey 2001), for a row of columns at a time.
#include "problems/wedged/precise_residual.hpp"

#include <vector>

#include <qd/inline.h>

namespace kusabi::problems {
namespace {

using numbers::Precise;
using Row = Eigen::Array<double, PreciseResidual::columns_at_once, 1>;

// Halves of a double, of 26 bits each.
template <class Number>
void split(const Number& number, Number& upper, Number& lower) {
  const Number large = _QD_SPLITTER * number;
  upper = large - (large - number);
  lower = number - upper;
}

// One row of 104-bit numbers.
struct PreciseRow {
  Row high, low;
};

struct SplitRow {
  PreciseRow row;
  Row upper, lower;  // of the high part
};

struct SplitNumber {
  explicit SplitNumber(const Precise& number) : high(number.x[0]), low(number.x[1]) {
    split(high, upper, lower);
  }
  double high, low, upper, lower;
};

// target -= factor * row, by parts that fit into registers.
void subtract_product(const SplitNumber& factor, const SplitRow& x, PreciseRow& target) {
  constexpr Eigen::Index width = 4;
  using Part = Eigen::Array<double, width, 1>;
  for (Eigen::Index at = 0; at < PreciseResidual::columns_at_once; at += width) {
    const auto part = [at](const Row& row) { return Part(row.segment<width>(at)); };
    const Part high = part(x.row.high), upper = part(x.upper), lower = part(x.lower);
    const Part before = part(target.high);
    const Part product = factor.high * high;
    const Part rest =
        (((factor.upper * upper - product) + factor.upper * lower + factor.lower * upper) +
         factor.lower * lower) +
        (factor.high * part(x.row.low) + factor.low * high);
    const Part sum = before - product;
    const Part back = sum - before;
    const Part low = (part(target.low) - rest) + ((before - (sum - back)) - (product + back));
    const Part after = sum + low;
    target.high.segment<width>(at) = after;
    target.low.segment<width>(at) = low - (after - sum);
  }
}

PreciseRow row_of(const numbers::PreciseMatrix& matrix, Eigen::Index row) {
  PreciseRow result{Row::Zero(), Row::Zero()};
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    result.high[column] = matrix(row, column).x[0];
    result.low[column] = matrix(row, column).x[1];
  }
  return result;
}

}  // namespace

PreciseResidual::PreciseResidual(const Eigen::SparseMatrix<Precise>& matrix) : matrix_(matrix) {}

numbers::PreciseMatrix PreciseResidual::operator()(const numbers::PreciseMatrix& solution,
                                                   const numbers::PreciseMatrix& right) const {
  std::vector<PreciseRow> left;
  left.reserve(static_cast<std::size_t>(right.rows()));
  for (Eigen::Index i = 0; i < right.rows(); ++i) left.push_back(row_of(right, i));
  SplitRow x;
  for (Eigen::Index k = 0; k < matrix_.outerSize(); ++k) {
    x.row = row_of(solution, k);
    split(x.row.high, x.upper, x.lower);
    for (Eigen::SparseMatrix<Precise>::InnerIterator entry(matrix_, k); entry; ++entry)
      subtract_product(SplitNumber(entry.value()), x, left[static_cast<std::size_t>(entry.row())]);
  }
  numbers::PreciseMatrix result(right.rows(), right.cols());
  for (Eigen::Index i = 0; i < right.rows(); ++i)
    for (Eigen::Index column = 0; column < right.cols(); ++column) {
      const auto& [high, low] = left[static_cast<std::size_t>(i)];
      result(i, column) = Precise(high[column], low[column]);
    }
  return result;
}

}  // namespace kusabi::problems
