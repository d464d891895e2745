// Residual B - K X in 104 bits of several columns at once: high and low parts lie side by side, and
// each number is split for exact products once instead of in every product.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "support/numbers/precise.hpp"

namespace kusabi::problems {

class PreciseResidual {
 public:
  /// Maximum number of columns at once.
  static constexpr Eigen::Index columns_at_once = 32;

  /// @param matrix K, n x n, which outlives this object; entries of at most 2^970
  explicit PreciseResidual(const Eigen::SparseMatrix<numbers::Precise>& matrix);

  /// B - K X. A product has a relative error, and a difference one relative to the sum of both
  /// sizes, below unit_roundoff<Precise>.
  /// @param solution X, n x c with c <= columns_at_once  @param right B, n x c
  [[nodiscard]] numbers::PreciseMatrix operator()(const numbers::PreciseMatrix& solution,
                                                  const numbers::PreciseMatrix& right) const;

 private:
  const Eigen::SparseMatrix<numbers::Precise>& matrix_;
};

}  // namespace kusabi::problems
