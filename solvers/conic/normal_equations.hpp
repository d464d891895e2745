// NormalEquations: M = B B' + diagonal of the interior-point iteration, solved by Cholesky
// factorisation. The typical size is so small that a general library spends its time on dispatch
// and packing.
#pragma once

#include <vector>

#include "solvers/conic/columns.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::conic {

/// M and its factor, on storage allocated once. All vectors have an entry for each row of M and for
/// the padding to whole packs, where M is the identity.
template <class Real = double>
class NormalEquations {
 public:
  explicit NormalEquations(int max_rows);

  /// Sets the number of rows of M, at most that of construction; call assemble() next.
  void resize(int rows);

  /// M = B B'.
  void assemble(const PackedColumns<Real>& b);

  const Real& diagonal(int row) const { return matrix_[place(row, row)]; }
  void add_to_diagonal(int row, const Real& value) { matrix_[place(row, row)] += value; }
  /// Adds weight h h' of a column h.
  void add_square(const Real* column, const Real& weight);

  /// Factorises M in place and solves it for two right sides, which are appended as rows below M
  /// for their forward substitution.
  /// @return false if a pivot is not positive
  bool factorise(Real* first, Real* second);

  /// Replaces X by X L^-T, L the factor: the sum of squares of a row is then c'M^-1 c for the
  /// former row c, and products of two rows likewise.
  /// @param x `height` rows, whole packs, by columns, one column for each row of M
  void reduce(Real* x, int height) const;

  /// Solves for one further right side, in place.
  void solve(Real* right_side) const;

 private:
  std::size_t place(int row, int column) const {
    return static_cast<std::size_t>(column * height_ + row);
  }

  int rows_, padded_rows_;
  int height_;  // of a column: padded_rows_ and two right sides
  std::vector<Real> matrix_;
  std::vector<Real> copied_;   // columns of B, by blocks of rows
  std::vector<Real> inverse_;  // of the diagonal of the factor
};

}  // namespace kusabi::conic
