// Cholesky factors of sparse symmetric matrices: by supernodes in doubles (CHOLMOD), by columns in
// other numbers (Eigen).
#pragma once

#include <memory>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// Sizes of the rows of L.
struct FactorRows {
  double maximum_sum = 0;   ///< largest row sum of |L| |L'|, up to its rounding errors
  int maximum_entries = 0;  ///< largest number of entries in a row
};

/// L L' = Q (M + s I) Q' with a permutation Q. For `double`, `long double` and `numbers::Precise`.
template <class Real>
class SparseFactor {
 public:
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

  /// @param matrix M, symmetric, both triangles  @param shift s
  explicit SparseFactor(const Eigen::SparseMatrix<Real>& matrix, const Real& shift = Real(0.0));

  /// False: M + s I is not positive definite, up to rounding.
  [[nodiscard]] bool exists() const { return factor_.info() == Eigen::Success; }

  /// Solves (M + s I) X = right in place. Several columns at once are faster, since reading L
  /// dominates. @pre exists()
  void solve(Matrix& right) const;

  /// @pre exists()
  [[nodiscard]] FactorRows rows() const;

 private:
  Eigen::SimplicialLLT<Eigen::SparseMatrix<Real>> factor_;
};

/// A nested dissection orders the unknowns; products of dense blocks are those of the BLAS, on one
/// thread.
template <>
class SparseFactor<double> {
 public:
  using Matrix = Eigen::MatrixXd;

  /// @throws std::bad_alloc also if L has more than 2^31 entries
  explicit SparseFactor(const Eigen::SparseMatrix<double>& matrix, double shift = 0);
  ~SparseFactor();
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  [[nodiscard]] bool exists() const;
  void solve(Matrix& right) const;
  [[nodiscard]] FactorRows rows() const;

 private:
  class Supernodes;
  std::unique_ptr<Supernodes> supernodes_;
};

extern template class SparseFactor<long double>;
extern template class SparseFactor<numbers::Precise>;

}  // namespace kusabi::problems
