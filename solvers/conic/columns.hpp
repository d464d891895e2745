// PackedColumns: the columns of the standard form of a node program, padded for packs, and their
// products with vectors. Column c of component d belongs to the cone c: the components of
// neighbouring cones lie side by side.
#pragma once

namespace kusabi::conic {

/// View of a matrix of `components` groups of columns, of which the first `count` are used. Rows
/// and columns are padded with zeros to whole packs.
template <class Real = double>
struct PackedColumns {
  const Real* data;
  int rows;        ///< padded; the distance between two columns
  int components;  ///< D
  int count;       ///< columns used, of each component
  int stride;      ///< padded; columns of each component
};

/// products = matrix' weights: components x stride numbers; those of unused columns are zero.
template <class Real>
void transposed_product(const PackedColumns<Real>& matrix, const Real* weights, Real* products);

/// sum = matrix * coefficients: `rows` numbers.
template <class Real>
void product(const PackedColumns<Real>& matrix, const Real* coefficients, Real* sum);

}  // namespace kusabi::conic
