// The block product of the dense kernels: a few packs of rows times as many columns as a pack has
// lanes, accumulated in registers.
#pragma once

#include "solvers/conic/pack.hpp"

namespace kusabi::conic {

// Packs in a block of rows: as many as give each block eight products that do not depend on each
// other, and fit the registers.
template <class Real>
inline constexpr int block_height = lanes<Real> == 1 ? 4 : 2;

// Columns that are copied at a time: a block of rows takes a quarter of the first cache.
inline constexpr int copied_columns = 128;

template <class Real, int Height>
using Sums = Packed<Real>[lanes<Real>][Height];

// sums += the block of X Y' below `x` and beside `y`, Height packs by one, for `count` columns.
template <int Height, class Real>
KUSABI_INLINE void add_products(const Real* x, int x_distance, const Real* y, int y_distance,
                                int count, Sums<Real, Height>& sums) {
  constexpr int width = lanes<Real>;
  for (int k = 0; k < count; ++k, x += x_distance, y += y_distance) {
    Packed<Real> left[Height];
    for (int i = 0; i < Height; ++i) left[i] = load(x + width * i);
    for (int j = 0; j < width; ++j) {
      const Packed<Real> right = y[j];
      for (int i = 0; i < Height; ++i) sums[j][i] += left[i] * right;
    }
  }
}

}  // namespace kusabi::conic
