// Left-looking Cholesky factorisation by panels of four columns; the rank update and the reduction
// of a panel by the previous ones are the same block product.
#include "solvers/conic/normal_equations.hpp"

#include <cmath>

#include "solvers/conic/pack.hpp"

namespace kusabi::conic {

namespace {

// Matrix by columns, with a distance of `distance` numbers.
struct ColumnView {
  double* data;
  int distance;
};

// sums += the block of X Y' below `x` and beside `y`, Height packs by four, for `count` columns.
template <int Height>
KUSABI_INLINE void add_products(const double* x, int x_distance, const double* y, int y_distance,
                                int count, Pack (&sums)[lanes][Height]) {
  for (int k = 0; k < count; ++k, x += x_distance, y += y_distance) {
    Pack left[Height];
    for (int i = 0; i < Height; ++i) left[i] = load(x + lanes * i);
    for (int j = 0; j < lanes; ++j) {
      const Pack right = y[j];
      for (int i = 0; i < Height; ++i) sums[j][i] += left[i] * right;
    }
  }
}

template <int Height>
KUSABI_INLINE void assemble_block(const PackedColumns& b, int row, int column, double* to,
                                  int distance) {
  Pack sums[lanes][Height] = {};
  for (int d = 0; d < b.components; ++d) {
    const double* const columns = b.data + d * b.stride * b.rows;
    add_products<Height>(columns + row, b.rows, columns + column, b.rows, b.count, sums);
  }
  for (int j = 0; j < lanes; ++j)
    for (int i = 0; i < Height; ++i)
      store(to + (column + j) * distance + row + lanes * i, sums[j][i]);
}

// Subtracts from a block of X, in the panel that starts at `column`, the contribution of the
// previous columns by the factor. The rows of X may be those of the factor itself.
template <int Height>
KUSABI_INLINE void reduce_block(ColumnView x, int row, const double* factor, int distance,
                                int column) {
  Pack sums[lanes][Height] = {};
  add_products<Height>(x.data + row, x.distance, factor + column, distance, column, sums);
  for (int j = 0; j < lanes; ++j)
    for (int i = 0; i < Height; ++i) {
      double* place = x.data + (column + j) * x.distance + row + lanes * i;
      store(place, load(place) - sums[j][i]);
    }
}

// Factorises the diagonal block; false if a pivot is not positive. The square roots come last,
// since each pivot depends on the one before.
KUSABI_INLINE bool factorise_block(double* block, int distance, double* inverse) {
  double a[lanes][lanes];
  for (int j = 0; j < lanes; ++j)
    for (int i = j; i < lanes; ++i) a[j][i] = block[j * distance + i];
  bool sound = true;
  for (int j = 0; j < lanes; ++j) {
    sound = sound && a[j][j] > 0;
    const double reciprocal = 1 / a[j][j];
    for (int k = j + 1; k < lanes; ++k) {
      const double share = a[j][k] * reciprocal;
      for (int i = k; i < lanes; ++i) a[k][i] -= share * a[j][i];
    }
  }
  store(inverse, 1.0 / root(Pack::Lanes{a[0][0], a[1][1], a[2][2], a[3][3]}));
  for (int j = 0; j < lanes; ++j)
    for (int i = j + 1; i < lanes; ++i) block[j * distance + i] = a[j][i] * inverse[j];
  return sound;
}

// Divides four rows of X in a panel by its diagonal block.
KUSABI_INLINE void divide_by_block(ColumnView x, int row, const double* factor, int distance,
                                   int column, const double* inverse) {
  const double* const block = factor + column * distance + column;
  double* const panel = x.data + column * x.distance + row;
  Pack columns[lanes];
  for (int j = 0; j < lanes; ++j) {
    columns[j] = load(panel + j * x.distance);
    for (int k = 0; k < j; ++k) columns[j] -= columns[k] * block[k * distance + j];
    columns[j] *= inverse[j];
  }
  for (int j = 0; j < lanes; ++j) store(panel + j * x.distance, columns[j]);
}

// Reduces the rows of X from `row` to `end` in one panel of X L^-T. @pre the panels before are done
KUSABI_INLINE void reduce_rows(ColumnView x, int row, int end, const double* factor, int distance,
                               int column) {
  for (; row + 2 * lanes <= end; row += 2 * lanes)
    reduce_block<2>(x, row, factor, distance, column);
  if (row < end) reduce_block<1>(x, row, factor, distance, column);
}

// Solves with the transpose of the factor, Count right sides in place.
template <int Count>
KUSABI_INLINE void substitute_back(const double* factor, int distance, int rows,
                                   const double* inverse, double* const (&sides)[Count]) {
  for (int column = rows - lanes; column >= 0; column -= lanes) {
    const double* panel = factor + column * distance;
    Pack sums[Count][lanes] = {};
    for (int i = column + lanes; i < rows; i += lanes)
      for (int j = 0; j < lanes; ++j) {
        const Pack entries = load(panel + j * distance + i);
        for (int n = 0; n < Count; ++n) sums[n][j] += entries * load(sides[n] + i);
      }
    const double* block = panel + column;
    for (int n = 0; n < Count; ++n) {
      const Pack rest = load(sides[n] + column) - totals(sums[n]);
      const double last = rest[3] * inverse[column + 3];
      const double third = (rest[2] - block[2 * distance + 3] * last) * inverse[column + 2];
      const double second = (rest[1] - block[distance + 3] * last - block[distance + 2] * third) *
                            inverse[column + 1];
      const double first =
          (rest[0] - block[3] * last - block[2] * third - block[1] * second) * inverse[column];
      store(sides[n] + column, Pack::Lanes{first, second, third, last});
    }
  }
}

}  // namespace

NormalEquations::NormalEquations(int most_rows)
    : rows_(most_rows),
      padded_rows_(padded(most_rows)),
      height_(padded_rows_ + lanes),
      matrix_(static_cast<std::size_t>(height_ * padded_rows_), 0.0),
      inverse_(static_cast<std::size_t>(padded_rows_), 0.0) {}

void NormalEquations::resize(int rows) {
  rows_ = rows;
  padded_rows_ = padded(rows);
  height_ = padded_rows_ + lanes;
}

KUSABI_ALSO_FOR_AVX2
void NormalEquations::assemble(const PackedColumns& b) {
  for (int column = 0; column < padded_rows_; column += lanes) {
    int row = column;
    for (; row + 2 * lanes <= padded_rows_; row += 2 * lanes)
      assemble_block<2>(b, row, column, matrix_.data(), height_);
    if (row < padded_rows_) assemble_block<1>(b, row, column, matrix_.data(), height_);
  }
  for (int row = rows_; row < padded_rows_; ++row) matrix_[place(row, row)] = 1;
}

KUSABI_ALSO_FOR_AVX2
void NormalEquations::add_square(const double* column, double weight) {
  for (int j = 0; j < rows_; ++j) {
    const double share = weight * column[j];
    if (share == 0) continue;
    for (int i = j; i < rows_; ++i) matrix_[place(i, j)] += share * column[i];
  }
}

KUSABI_ALSO_FOR_AVX2
bool NormalEquations::factorise(double* first, double* second) {
  double* const matrix = matrix_.data();
  for (int column = 0; column < padded_rows_; ++column)
    store(matrix + column * height_ + padded_rows_,
          Pack::Lanes{first[column], second[column], 0, 0});
  for (int column = 0; column < padded_rows_; column += lanes) {
    reduce_rows({matrix, height_}, column, height_, matrix, height_, column);
    double* const inverse = inverse_.data() + column;
    if (!factorise_block(matrix + column * height_ + column, height_, inverse)) return false;
    for (int row = column + lanes; row < height_; row += lanes)
      divide_by_block({matrix, height_}, row, matrix, height_, column, inverse);
  }
  for (int column = 0; column < padded_rows_; ++column) {
    first[column] = matrix[column * height_ + padded_rows_];
    second[column] = matrix[column * height_ + padded_rows_ + 1];
  }
  substitute_back<2>(matrix, height_, padded_rows_, inverse_.data(), {first, second});
  return true;
}

KUSABI_ALSO_FOR_AVX2
void NormalEquations::reduce(double* x, int height) const {
  for (int column = 0; column < padded_rows_; column += lanes) {
    reduce_rows({x, height}, 0, height, matrix_.data(), height_, column);
    for (int row = 0; row < height; row += lanes)
      divide_by_block({x, height}, row, matrix_.data(), height_, column, inverse_.data() + column);
  }
}

KUSABI_ALSO_FOR_AVX2
void NormalEquations::solve(double* right_side) const {
  const double* const matrix = matrix_.data();
  for (int column = 0; column < padded_rows_; column += lanes) {
    const double* panel = matrix + column * height_;
    const double* block = panel + column;
    const double* inverse = inverse_.data() + column;
    double* side = right_side + column;
    for (int j = 0; j < lanes; ++j) {
      for (int k = 0; k < j; ++k) side[j] -= block[k * height_ + j] * side[k];
      side[j] *= inverse[j];
    }
    for (int i = column + lanes; i < padded_rows_; i += lanes) {
      Pack rest = load(right_side + i);
      for (int j = 0; j < lanes; ++j) rest -= load(panel + j * height_ + i) * side[j];
      store(right_side + i, rest);
    }
  }
  substitute_back<1>(matrix, height_, padded_rows_, inverse_.data(), {right_side});
}

}  // namespace kusabi::conic
