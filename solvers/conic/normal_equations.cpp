// Left-looking Cholesky factorisation by panels of as many columns as a pack has lanes; the rank
// update and the reduction of a panel by the previous ones are the same block product.
#include "solvers/conic/normal_equations.hpp"

#include <algorithm>
#include <cstddef>

#include "solvers/conic/block_product.hpp"

namespace kusabi::conic {

namespace {

// Smaller matrices stay in the cache without copies.
constexpr int max_direct_rows = 48;

// Right sides appended below M.
constexpr int sides = 2;

// Matrix by columns, with a distance of `distance` numbers.
template <class Real>
struct ColumnView {
  Real* data;
  int distance;
};

// Adds the block of B B' of the rows at `x` and at `y` to `sum`, or puts it there.
template <int Height, class Real>
KUSABI_INLINE void assemble_block(const PackedColumns<Real>& b, const Real* x, const Real* y,
                                  Real* sum, int distance, bool begins) {
  constexpr int width = lanes<Real>;
  Sums<Real, Height> sums = {};
  if (!begins)
    for (int j = 0; j < width; ++j)
      for (int i = 0; i < Height; ++i) sums[j][i] = load(sum + j * distance + width * i);
  for (int d = 0; d < b.components; ++d) {
    const auto first = static_cast<std::ptrdiff_t>(d) * b.stride * b.rows;
    add_products<Height>(x + first, b.rows, y + first, b.rows, b.count, sums);
  }
  for (int j = 0; j < width; ++j)
    for (int i = 0; i < Height; ++i) store(sum + j * distance + width * i, sums[j][i]);
}

template <class Real>
KUSABI_INLINE void assemble_rows(const PackedColumns<Real>& b, const Real* x, int rows,
                                 const Real* y, Real* sum, int distance, bool begins) {
  constexpr int width = lanes<Real>, height = block_height<Real>;
  int row = 0;
  for (; row + height * width <= rows; row += height * width)
    assemble_block<height>(b, x + row, y, sum + row, distance, begins);
  for (; row < rows; row += width) assemble_block<1>(b, x + row, y, sum + row, distance, begins);
}

// Subtracts from a block of X, in the panel that starts at `column`, the contribution of the
// previous columns by the factor. The rows of X may be those of the factor itself.
template <int Height, class Real>
KUSABI_INLINE void reduce_block(ColumnView<Real> x, int row, const Real* factor, int distance,
                                int column) {
  constexpr int width = lanes<Real>;
  Sums<Real, Height> sums = {};
  add_products<Height>(x.data + row, x.distance, factor + column, distance, column, sums);
  for (int j = 0; j < width; ++j)
    for (int i = 0; i < Height; ++i) {
      Real* place = x.data + (column + j) * x.distance + row + width * i;
      store(place, load(place) - sums[j][i]);
    }
}

// Factorises the diagonal block; false if a pivot is not positive. The square roots come last,
// since each pivot depends on the one before.
template <class Real>
KUSABI_INLINE bool factorise_block(Real* block, int distance, Real* inverse) {
  constexpr int width = lanes<Real>;
  Real a[width][width], pivots[width];
  for (int j = 0; j < width; ++j)
    for (int i = j; i < width; ++i) a[j][i] = block[j * distance + i];
  bool sound = true;
  for (int j = 0; j < width; ++j) {
    sound = sound && a[j][j] > 0;
    pivots[j] = a[j][j];
    const Real reciprocal = 1.0 / a[j][j];
    for (int k = j + 1; k < width; ++k) {
      const Real share = a[j][k] * reciprocal;
      for (int i = k; i < width; ++i) a[k][i] -= share * a[j][i];
    }
  }
  store(inverse, 1.0 / root(pack_of(pivots)));
  for (int j = 0; j < width; ++j)
    for (int i = j + 1; i < width; ++i) block[j * distance + i] = a[j][i] * inverse[j];
  return sound;
}

// Divides a pack of rows of X in a panel by its diagonal block.
template <class Real>
KUSABI_INLINE void divide_by_block(ColumnView<Real> x, int row, const Real* factor, int distance,
                                   int column, const Real* inverse) {
  constexpr int width = lanes<Real>;
  const Real* const block = factor + column * distance + column;
  Real* const panel = x.data + column * x.distance + row;
  Packed<Real> columns[width];
  for (int j = 0; j < width; ++j) {
    columns[j] = load(panel + j * x.distance);
    for (int k = 0; k < j; ++k) columns[j] -= columns[k] * block[k * distance + j];
    columns[j] *= inverse[j];
  }
  for (int j = 0; j < width; ++j) store(panel + j * x.distance, columns[j]);
}

// Reduces the rows of X from `row` to `end` in one panel of X L^-T. @pre the panels before are done
template <class Real>
KUSABI_INLINE void reduce_rows(ColumnView<Real> x, int row, int end, const Real* factor,
                               int distance, int column) {
  constexpr int width = lanes<Real>, height = block_height<Real>;
  for (; row + height * width <= end; row += height * width)
    reduce_block<height>(x, row, factor, distance, column);
  for (; row < end; row += width) reduce_block<1>(x, row, factor, distance, column);
}

// Solves with the transpose of the factor, Count right sides in place.
template <int Count, class Real>
KUSABI_INLINE void substitute_back(const Real* factor, int distance, int rows, const Real* inverse,
                                   Real* const (&right_sides)[Count]) {
  constexpr int width = lanes<Real>;
  for (int column = rows - width; column >= 0; column -= width) {
    const Real* panel = factor + column * distance;
    Packed<Real> sums[Count][width] = {};
    for (int i = column + width; i < rows; i += width)
      for (int j = 0; j < width; ++j) {
        const Packed<Real> entries = load(panel + j * distance + i);
        for (int n = 0; n < Count; ++n) sums[n][j] += entries * load(right_sides[n] + i);
      }
    const Real* block = panel + column;
    for (int n = 0; n < Count; ++n) {
      Real rest[width];
      const Packed<Real> reduced = load(right_sides[n] + column) - totals(sums[n]);
      for (int j = 0; j < width; ++j) rest[j] = in_lane(reduced, j);
      for (int j = width - 1; j >= 0; --j) {
        for (int k = width - 1; k > j; --k) rest[j] -= block[j * distance + k] * rest[k];
        rest[j] *= inverse[column + j];
      }
      store(right_sides[n] + column, pack_of(rest));
    }
  }
}

// M, by columns of `height` numbers: `rows` of M, padded, and the right sides.
template <class Real>
struct Equations {
  Real* matrix;
  int rows, height;

  Real* place(int row, int column) const { return matrix + column * height + row; }
};

// Its factor, and the inverse of the diagonal of the factor.
template <class Real>
struct Factor {
  const Real* matrix;
  const Real* inverse;
  int rows, height;
};

// The functions compiled for two instruction sets are free functions: GCC drops the attribute from
// members of a class template unless their declaration has it too, and then every unit that includes
// the declaration refers to clones that only one unit defines.

// M = B B', with B where it lies.
template <class Real>
KUSABI_ALSO_FOR_AVX2 void assemble_in_place(const PackedColumns<Real>& b, Equations<Real> m) {
  for (int column = 0; column < m.rows; column += lanes<Real>)
    assemble_rows(b, b.data + column, m.rows - column, b.data + column, m.place(column, column),
                  m.height, true);
}

// Adds the products of `count` columns of a component of B, from `columns` on, or puts them there.
// Each block of rows is copied, so that its columns lie side by side, and multiplied by all those
// before it while it is in the first cache.
template <class Real>
KUSABI_ALSO_FOR_AVX2 void add_copied(const Real* columns, int distance, int count, Real* copied,
                                     Equations<Real> m, bool begins) {
  constexpr int width = lanes<Real>, height = block_height<Real> * width;
  const auto copy_of = [&](int row) {
    return copied + row / height * height * copied_columns + row % height;
  };
  for (int k = 0; k < count; ++k)
    for (int row = 0; row < m.rows; row += width)
      store(copy_of(row) + k * height, load(columns + std::ptrdiff_t{k} * distance + row));
  const PackedColumns<Real> block{copied, height, 1, count, count};
  for (int left = 0; left < m.rows; left += height)
    for (int row = left; row < m.rows; row += height)
      for (int column = left; column < std::min(left + height, m.rows); column += width)
        assemble_rows(block, copy_of(row), std::min(height, m.rows - row), copy_of(column),
                      m.place(row, column), m.height, begins);
}

template <class Real>
KUSABI_ALSO_FOR_AVX2 void add_square_of(const Real* column, const Real& weight, int rows,
                                        Equations<Real> m) {
  for (int j = 0; j < rows; ++j) {
    const Real share = weight * column[j];
    if (share == 0) continue;
    for (int i = j; i < rows; ++i) *m.place(i, j) += share * column[i];
  }
}

template <class Real>
KUSABI_ALSO_FOR_AVX2 bool factorise_and_solve(Equations<Real> m, Real* inverses, Real* first,
                                              Real* second) {
  constexpr int width = lanes<Real>;
  for (int column = 0; column < m.rows; ++column)
    store_two(m.place(m.rows, column), first[column], second[column]);
  for (int column = 0; column < m.rows; column += width) {
    reduce_rows<Real>({m.matrix, m.height}, column, m.height, m.matrix, m.height, column);
    Real* const inverse = inverses + column;
    if (!factorise_block(m.place(column, column), m.height, inverse)) return false;
    for (int row = column + width; row < m.height; row += width)
      divide_by_block<Real>({m.matrix, m.height}, row, m.matrix, m.height, column, inverse);
  }
  for (int column = 0; column < m.rows; ++column) {
    first[column] = *m.place(m.rows, column);
    second[column] = *m.place(m.rows + 1, column);
  }
  substitute_back<sides>(m.matrix, m.height, m.rows, inverses, {first, second});
  return true;
}

template <class Real>
KUSABI_ALSO_FOR_AVX2 void reduce_by_factor(Factor<Real> factor, Real* x, int height) {
  constexpr int width = lanes<Real>;
  for (int column = 0; column < factor.rows; column += width) {
    reduce_rows<Real>({x, height}, 0, height, factor.matrix, factor.height, column);
    for (int row = 0; row < height; row += width)
      divide_by_block<Real>({x, height}, row, factor.matrix, factor.height, column,
                            factor.inverse + column);
  }
}

template <class Real>
KUSABI_ALSO_FOR_AVX2 void solve_by_factor(Factor<Real> factor, Real* right_side) {
  constexpr int width = lanes<Real>;
  for (int column = 0; column < factor.rows; column += width) {
    const Real* panel = factor.matrix + column * factor.height;
    const Real* block = panel + column;
    const Real* inverse = factor.inverse + column;
    Real* side = right_side + column;
    for (int j = 0; j < width; ++j) {
      for (int k = 0; k < j; ++k) side[j] -= block[k * factor.height + j] * side[k];
      side[j] *= inverse[j];
    }
    for (int i = column + width; i < factor.rows; i += width) {
      Packed<Real> rest = load(right_side + i);
      for (int j = 0; j < width; ++j) rest -= load(panel + j * factor.height + i) * side[j];
      store(right_side + i, rest);
    }
  }
  substitute_back<1>(factor.matrix, factor.height, factor.rows, factor.inverse, {right_side});
}

}  // namespace

template <class Real>
NormalEquations<Real>::NormalEquations(int max_rows) {
  resize(max_rows);
  matrix_.assign(static_cast<std::size_t>(height_ * padded_rows_), Real(0));
  if (padded_rows_ > max_direct_rows)
    copied_.assign(static_cast<std::size_t>(copied_columns) *
                       static_cast<std::size_t>(padded_rows_ + block_height<Real> * lanes<Real>),
                   Real(0));
  inverse_.assign(static_cast<std::size_t>(padded_rows_), Real(0));
}

template <class Real>
void NormalEquations<Real>::resize(int rows) {
  rows_ = rows;
  padded_rows_ = padded<Real>(rows);
  height_ = padded_rows_ + padded<Real>(sides);
}

template <class Real>
void NormalEquations<Real>::assemble(const PackedColumns<Real>& b) {
  const Equations<Real> m{matrix_.data(), padded_rows_, height_};
  if (padded_rows_ <= max_direct_rows) {
    assemble_in_place(b, m);
  } else {
    for (int d = 0; d < b.components; ++d)
      for (int first = 0; first < b.count; first += copied_columns)
        add_copied(b.data + std::ptrdiff_t{d * b.stride + first} * b.rows, b.rows,
                   std::min(copied_columns, b.count - first), copied_.data(), m,
                   d == 0 && first == 0);
  }
  for (int row = rows_; row < padded_rows_; ++row) matrix_[place(row, row)] = Real(1);
}

template <class Real>
void NormalEquations<Real>::add_square(const Real* column, const Real& weight) {
  add_square_of<Real>(column, weight, rows_, {matrix_.data(), padded_rows_, height_});
}

template <class Real>
bool NormalEquations<Real>::factorise(Real* first, Real* second) {
  return factorise_and_solve<Real>({matrix_.data(), padded_rows_, height_}, inverse_.data(), first,
                                   second);
}

template <class Real>
void NormalEquations<Real>::reduce(Real* x, int height) const {
  reduce_by_factor<Real>({matrix_.data(), inverse_.data(), padded_rows_, height_}, x, height);
}

template <class Real>
void NormalEquations<Real>::solve(Real* right_side) const {
  solve_by_factor<Real>({matrix_.data(), inverse_.data(), padded_rows_, height_}, right_side);
}

template class NormalEquations<double>;
template class NormalEquations<long double>;
template class NormalEquations<numbers::Precise>;

}  // namespace kusabi::conic
