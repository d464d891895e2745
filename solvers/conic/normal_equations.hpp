// The normal equations of the interior-point iteration, M = B B' + diagonal, by Cholesky: mostly of
// a size at which a general library spends its time on dispatch and packing.
#pragma once

#include <vector>

#include "solvers/conic/columns.hpp"

namespace kusabi::conic {

/// M and its factor, on storage that is allocated once. All vectors have an entry for each row of M
/// and for those that fill it up to a multiple of four, where M is the identity.
class NormalEquations {
 public:
  explicit NormalEquations(int most_rows);

  /// From now on M has so many rows, no more than at construction; call assemble() next.
  void resize(int rows);

  /// M = B B'.
  void assemble(const Columns& b);

  double diagonal(int row) const { return matrix_[place(row, row)]; }
  void add_to_diagonal(int row, double value) { matrix_[place(row, row)] += value; }
  /// Adds weight h h' of a column h.
  void add_square(const double* column, double weight);

  /// Factorises M in place and solves it for two right sides, which ride along as rows below M:
  /// that is their forward substitution.
  /// @return false when a pivot is not positive
  bool factorise(double* first, double* second);

  /// X L^-T in the place of X, L the factor: the squares of a row then add up to c'M^-1 c, c what
  /// the row was, and products of two rows likewise.
  /// @param x `height` rows, a multiple of four, by columns, one for each row of M
  void reduce(double* x, int height) const;

  /// Solves for one more right side, in place.
  void solve(double* right_side) const;

 private:
  std::size_t place(int row, int column) const {
    return static_cast<std::size_t>(column * height_ + row);
  }

  int rows_, padded_rows_;
  int height_;  // of a column: padded_rows_ and a pack of right sides
  std::vector<double> matrix_;
  std::vector<double> inverse_;  // of the diagonal of the factor
};

}  // namespace kusabi::conic
