// Blocked solutions with a factor of Eigen, whose own read it once for each column.
#include "problems/structure/factor/sparse_factor.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "problems/structure/factor/factor_rows.hpp"

namespace kusabi::problems {
namespace {

/// Columns solved at once: the factor is read once for all of them.
constexpr std::size_t block = 32;

template <class Real>
using Block = std::vector<std::array<Real, block>>;

/// Solves L y = x, then L' x = y in place.
template <class Real>
void substitute(const Eigen::SparseMatrix<Real>& lower, Block<Real>& x) {
  using Entry = typename Eigen::SparseMatrix<Real>::InnerIterator;
  for (Eigen::Index column = 0; column < lower.cols(); ++column) {
    Entry entry(lower, column);  // the diagonal comes first
    auto& own = x[static_cast<std::size_t>(column)];
    for (Real& value : own) value /= entry.value();
    for (++entry; entry; ++entry) {
      auto& other = x[static_cast<std::size_t>(entry.row())];
      for (std::size_t k = 0; k < block; ++k) other[k] -= entry.value() * own[k];
    }
  }
  for (Eigen::Index column = lower.cols(); column-- > 0;) {
    Entry entry(lower, column);
    const Real diagonal = entry.value();
    auto own = x[static_cast<std::size_t>(column)];
    for (++entry; entry; ++entry) {
      const auto& other = x[static_cast<std::size_t>(entry.row())];
      for (std::size_t k = 0; k < block; ++k) own[k] -= entry.value() * other[k];
    }
    for (Real& value : own) value /= diagonal;
    x[static_cast<std::size_t>(column)] = own;
  }
}

}  // namespace

template <class Real>
SparseFactor<Real>::SparseFactor(const Eigen::SparseMatrix<Real>& matrix, const Real& shift) {
  factor_.setShift(shift);
  factor_.compute(matrix);
}

template <class Real>
void SparseFactor<Real>::solve(Matrix& right) const {
  const auto& lower = factor_.matrixL().nestedExpression();
  const auto& place = factor_.permutationP().indices();  // empty: no permutation
  const auto at = [&](Eigen::Index row) {
    return static_cast<std::size_t>(place.size() > 0 ? place(row) : row);
  };
  Block<Real> part(static_cast<std::size_t>(right.rows()));
  constexpr auto width = static_cast<Eigen::Index>(block);
  for (Eigen::Index first = 0; first < right.cols(); first += width) {
    const auto count = std::min(width, right.cols() - first);
    for (auto& row : part) row.fill(Real(0.0));
    for (Eigen::Index k = 0; k < count; ++k) {
      for (Eigen::Index row = 0; row < right.rows(); ++row)
        part[at(row)][static_cast<std::size_t>(k)] = right(row, first + k);
    }
    substitute<Real>(lower, part);
    for (Eigen::Index k = 0; k < count; ++k) {
      for (Eigen::Index row = 0; row < right.rows(); ++row)
        right(row, first + k) = part[at(row)][static_cast<std::size_t>(k)];
    }
  }
}

template <class Real>
FactorRows SparseFactor<Real>::rows() const {
  const Eigen::SparseMatrix<Real>& lower = factor_.matrixL().nestedExpression();
  return rows_of_factor(lower.rows(), [&](const auto& use) {
    for (Eigen::Index column = 0; column < lower.cols(); ++column) {
      for (typename Eigen::SparseMatrix<Real>::InnerIterator entry(lower, column); entry; ++entry)
        use(entry.row(), column, numbers::rounded(entry.value()));
    }
  });
}

template class SparseFactor<long double>;
template class SparseFactor<numbers::Precise>;

}  // namespace kusabi::problems
