// Products with the padded columns, accumulated in registers.
#include "solvers/conic/columns.hpp"

#include "solvers/conic/pack.hpp"

namespace kusabi::conic {

namespace {

// Product for several rows, in packs, in one pass over the columns.
template <int Height, class Real>
KUSABI_INLINE void product_of_rows(const PackedColumns<Real>& matrix, const Real* coefficients,
                                   int row, Real* sum) {
  constexpr int width = lanes<Real>;
  Packed<Real> sums[Height] = {};
  for (int d = 0; d < matrix.components; ++d) {
    const Real* column = matrix.data + d * matrix.stride * matrix.rows + row;
    const Real* coefficient = coefficients + d * matrix.stride;
    for (int c = 0; c < matrix.count; ++c, column += matrix.rows) {
      const Packed<Real> factor = coefficient[c];
      for (int i = 0; i < Height; ++i) sums[i] += factor * load(column + width * i);
    }
  }
  for (int i = 0; i < Height; ++i) store(sum + row + width * i, sums[i]);
}

}  // namespace

template <class Real>
KUSABI_ALSO_FOR_AVX2 void transposed_product(const PackedColumns<Real>& matrix, const Real* weights,
                                             Real* products) {
  constexpr int width = lanes<Real>;
  const int rows = matrix.rows;
  for (int d = 0; d < matrix.components; ++d)
    for (int c = 0; c < matrix.count; c += width) {
      const Real* column = matrix.data + (d * matrix.stride + c) * rows;
      Packed<Real> sums[width] = {};
      for (int i = 0; i < rows; i += width) {
        const Packed<Real> weight = load(weights + i);
        for (int j = 0; j < width; ++j) sums[j] += load(column + j * rows + i) * weight;
      }
      store(products + d * matrix.stride + c, totals(sums));
    }
}

template <class Real>
KUSABI_ALSO_FOR_AVX2 void product(const PackedColumns<Real>& matrix, const Real* coefficients,
                                  Real* sum) {
  constexpr int width = lanes<Real>;
  int row = 0;
  for (; row + 8 * width <= matrix.rows; row += 8 * width)
    product_of_rows<8>(matrix, coefficients, row, sum);
  for (; row + 3 * width <= matrix.rows; row += 3 * width)
    product_of_rows<3>(matrix, coefficients, row, sum);
  for (; row < matrix.rows; row += width) product_of_rows<1>(matrix, coefficients, row, sum);
}

template void transposed_product(const PackedColumns<double>&, const double*, double*);
template void transposed_product(const PackedColumns<long double>&, const long double*,
                                 long double*);
template void transposed_product(const PackedColumns<numbers::Precise>&, const numbers::Precise*,
                                 numbers::Precise*);
template void product(const PackedColumns<double>&, const double*, double*);
template void product(const PackedColumns<long double>&, const long double*, long double*);
template void product(const PackedColumns<numbers::Precise>&, const numbers::Precise*,
                      numbers::Precise*);

}  // namespace kusabi::conic
