// PackedColumns: the columns of the standard form of a node program, padded for packs of four, and
// their products with vectors. Column c of component d belongs to the cone c: the components of
// four neighbouring cones lie side by side.
#pragma once

namespace kusabi::conic {

/// View of a matrix of `components` groups of columns, of which the first `count` are used. Rows
/// and columns are padded with zeros to multiples of four.
struct PackedColumns {
  const double* data;
  int rows;        ///< padded; the distance between two columns
  int components;  ///< D
  int count;       ///< columns used, of each component
  int stride;      ///< padded; columns of each component
};

/// products = matrix' weights: components x stride numbers; those of unused columns are zero.
void transposed_product(const PackedColumns& matrix, const double* weights, double* products);

/// sum = matrix * coefficients: `rows` numbers.
void product(const PackedColumns& matrix, const double* coefficients, double* sum);

}  // namespace kusabi::conic
