// Cholesky factor of a scaled stiffness, for solutions and for a proved bound of the least
// eigenvalue.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/structure/factor/sparse_factor.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// L L' = M - s I, M rounded to `Real`.
template <class Real>
class StiffnessFactor {
 public:
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

  /// @param matrix M, symmetric, both triangles
  explicit StiffnessFactor(const Eigen::SparseMatrix<numbers::Precise>& matrix);

  [[nodiscard]] bool exists() const { return factor_.exists(); }

  /// Solves M X = right in place. Several columns at once are faster.
  void solve(Matrix& right) const { factor_.solve(right); }

  /// Proved lower bound of the least eigenvalue of M; zero if there is none. If Cholesky's method
  /// succeeds for M - s I, in any order of the sums, it gives L with
  /// |L L' - (M - s I)| <= g |L| |L'| entry by entry, g = (k + 1) u, if no row of L has more than k
  /// entries (Higham, Accuracy and Stability of Numerical Algorithms, theorem 10.3); the norm of
  /// |L| |L'| is at most its largest row sum.
  [[nodiscard]] double min_eigenvalue() const;

 private:
  [[nodiscard]] double estimated_eigenvalue() const;

  Eigen::SparseMatrix<Real> matrix_;
  SparseFactor<Real> factor_;
};

extern template class StiffnessFactor<double>;
extern template class StiffnessFactor<long double>;
extern template class StiffnessFactor<numbers::Precise>;

}  // namespace kusabi::problems
