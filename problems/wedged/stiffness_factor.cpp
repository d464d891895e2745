// Inverse iteration, and an error bound from the entries of the factor.
#include "problems/wedged/stiffness_factor.hpp"

#include <cmath>

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

/// Bound of the norm of the rounding errors of the factor.
template <class Real>
double factor_error(const SparseFactor<Real>& factor) {
  const FactorRows rows = factor.rows();
  const double roundings = each_counts * (rows.maximum_entries + other_roundings);
  return sum_safety * roundings * numbers::unit_roundoff<Real> * rows.maximum_sum;
}

}  // namespace

template <class Real>
StiffnessFactor<Real>::StiffnessFactor(const Eigen::SparseMatrix<numbers::Precise>& matrix)
    : matrix_(matrix.cast<Real>()), factor_(matrix_) {}

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
    const SparseFactor<Real> shifted(matrix_, Real(-shift));
    if (!shifted.exists()) continue;
    const double bound = shift - factor_error(shifted) - cast_error;
    return bound > shift / 2 ? bound : 0;
  }
  return 0;
}

template class StiffnessFactor<double>;
template class StiffnessFactor<long double>;
template class StiffnessFactor<numbers::Precise>;

}  // namespace kusabi::problems
