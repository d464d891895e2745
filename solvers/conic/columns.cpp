// Products with the padded columns, accumulated in registers.
#include "solvers/conic/columns.hpp"

#include "solvers/conic/pack.hpp"

namespace kusabi::conic {

namespace {

// Product for several rows, in packs, in one pass over the columns.
template <int Height>
KUSABI_INLINE void product_of_rows(const PackedColumns& matrix, const double* coefficients, int row,
                                   double* sum) {
  Pack sums[Height] = {};
  for (int d = 0; d < matrix.components; ++d) {
    const double* column = matrix.data + d * matrix.stride * matrix.rows + row;
    const double* coefficient = coefficients + d * matrix.stride;
    for (int c = 0; c < matrix.count; ++c, column += matrix.rows) {
      const Pack factor = coefficient[c];
      for (int i = 0; i < Height; ++i) sums[i] += factor * load(column + lanes * i);
    }
  }
  for (int i = 0; i < Height; ++i) store(sum + row + lanes * i, sums[i]);
}

}  // namespace

KUSABI_ALSO_FOR_AVX2
void transposed_product(const PackedColumns& matrix, const double* weights, double* products) {
  const int rows = matrix.rows;
  for (int d = 0; d < matrix.components; ++d)
    for (int c = 0; c < matrix.count; c += lanes) {
      const double* column = matrix.data + (d * matrix.stride + c) * rows;
      Pack sums[lanes] = {};
      for (int i = 0; i < rows; i += lanes) {
        const Pack weight = load(weights + i);
        for (int j = 0; j < lanes; ++j) sums[j] += load(column + j * rows + i) * weight;
      }
      store(products + d * matrix.stride + c, totals(sums));
    }
}

KUSABI_ALSO_FOR_AVX2
void product(const PackedColumns& matrix, const double* coefficients, double* sum) {
  int row = 0;
  for (; row + 8 * lanes <= matrix.rows; row += 8 * lanes)
    product_of_rows<8>(matrix, coefficients, row, sum);
  for (; row + 3 * lanes <= matrix.rows; row += 3 * lanes)
    product_of_rows<3>(matrix, coefficients, row, sum);
  for (; row < matrix.rows; row += lanes) product_of_rows<1>(matrix, coefficients, row, sum);
}

}  // namespace kusabi::conic
