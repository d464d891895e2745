// Blocked solutions, and an error bound from the entries of the factor.
#include "problems/wedged/stiffness_factor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace kusabi::problems {
namespace {

/// Maximum number of candidates for the least eigenvalue: half of its estimate and smaller shares.
constexpr int max_trials = 4;

/// Rounding errors of an entry besides the products of a row: the conversion, the shift, the
/// division or root. All are counted four times, since operations in 104 bits have errors relative
/// to their operands.
constexpr double other_roundings = 8;
constexpr double each_counts = 4;

/// Factor for the rounding errors of sums of some thousand nonnegative numbers.
constexpr double sum_safety = 1.001;

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

/// Bound of the norm of the rounding errors of the factor.
template <class Real>
double factor_error(const Eigen::SparseMatrix<Real>& lower) {
  Eigen::VectorXd columns = Eigen::VectorXd::Zero(lower.cols());  // |L|' times the vector of ones
  Eigen::VectorXi entries = Eigen::VectorXi::Zero(lower.rows());
  const auto for_all = [&](const auto& use) {
    for (Eigen::Index column = 0; column < lower.cols(); ++column) {
      for (typename Eigen::SparseMatrix<Real>::InnerIterator entry(lower, column); entry; ++entry)
        use(entry.row(), column, std::abs(numbers::rounded(entry.value())));
    }
  };
  for_all([&](Eigen::Index row, Eigen::Index column, double size) {
    columns(column) += size;
    ++entries(row);
  });
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(lower.rows());
  for_all([&](Eigen::Index row, Eigen::Index column, double size) {
    rows(row) += size * columns(column);
  });
  const double roundings = each_counts * (entries.maxCoeff() + other_roundings);
  return sum_safety * roundings * numbers::unit_roundoff<Real> * rows.maxCoeff();
}

}  // namespace

template <class Real>
StiffnessFactor<Real>::StiffnessFactor(const Eigen::SparseMatrix<numbers::Precise>& matrix)
    : matrix_(matrix.cast<Real>()) {
  factor_.compute(matrix_);
}

template <class Real>
void StiffnessFactor<Real>::solve(Matrix& right) const {
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
double StiffnessFactor<Real>::estimated_eigenvalue() const {
  Matrix motion(matrix_.rows(), 1);
  for (Eigen::Index i = 0; i < motion.rows(); ++i)
    motion(i) = Real(1.0 + 0.37 * std::sin(static_cast<double>(i)));
  double estimate = 0;
  for (int step = 0; step < 8; ++step) {
    const double before = numbers::rounded(Real(motion.norm()));
    solve(motion);
    const double growth = numbers::rounded(Real(motion.norm()));
    estimate = before / growth;
    motion /= Real(growth);
  }
  return estimate;
}

template <class Real>
double StiffnessFactor<Real>::min_eigenvalue() const {
  if (!exists()) return 0;
  // Rounding error of the conversion, in the row-sum norm.
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(matrix_.cols());
  for (Eigen::Index column = 0; column < matrix_.outerSize(); ++column) {
    for (typename Eigen::SparseMatrix<Real>::InnerIterator entry(matrix_, column); entry; ++entry)
      sums(column) += std::abs(numbers::rounded(entry.value()));
  }
  const double cast_error =
      sum_safety * 2 * numbers::unit_roundoff<Real> * (sums.size() == 0 ? 0 : sums.maxCoeff());
  double shift = estimated_eigenvalue() / 2;
  for (int trial = 0; trial < max_trials && shift > 0; ++trial, shift /= 8) {
    Eigen::SimplicialLLT<Eigen::SparseMatrix<Real>> shifted;
    shifted.setShift(Real(-shift));
    shifted.compute(matrix_);
    if (shifted.info() != Eigen::Success) continue;
    const double bound =
        shift - factor_error<Real>(shifted.matrixL().nestedExpression()) - cast_error;
    return bound > shift / 2 ? bound : 0;
  }
  return 0;
}

template class StiffnessFactor<double>;
template class StiffnessFactor<long double>;
template class StiffnessFactor<numbers::Precise>;

}  // namespace kusabi::problems
