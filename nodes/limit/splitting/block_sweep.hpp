// One pass over the columns of this rank: each block is reflected by rows, projected onto A X = T,
// and passed on by rows.
#pragma once

#include <vector>

#include "nodes/limit/splitting/affine_projection.hpp"
#include "nodes/limit/splitting/column_blocks.hpp"

namespace kusabi::limit::splitting {

/// A block of a group.
struct BlockPlace {
  int group = 0;
  int number = 0;
  [[nodiscard]] int first_column() const { return group * group_columns + number * block_columns; }
};

/// @param right_sides by column
/// @param reflect (place, row, z) -> Segment: 2 x - z
/// @param visit (place, row, 2 x - z, y)
template <class Reflect, class Visit>
KUSABI_INLINE void sweep(AffineProjection& projection, const std::vector<SparseLoad>& right_sides,
                         const ColumnBlocks& z, const Reflect& reflect, const Visit& visit) {
  std::vector<Segment> w(static_cast<std::size_t>(z.rows()));
  for (BlockPlace place{z.first_group(), 0}; place.group < z.end_group(); ++place.group) {
    for (place.number = 0; place.number < z.blocks_of(place.group); ++place.number) {
      const Segment* const block = z.block(place.group, place.number);
      projection.begin(right_sides, place.first_column());
      for (int i = 0; i < z.rows(); ++i) {
        auto& row = w[static_cast<std::size_t>(i)];
        row = reflect(place, i, block[i]);
        projection.take(i, row);
      }
      projection.solve();
      for (int i = 0; i < z.rows(); ++i) {
        const auto& row = w[static_cast<std::size_t>(i)];
        Segment y = row;
        projection.project(i, y);
        visit(place, i, row, y);
      }
    }
  }
}

}  // namespace kusabi::limit::splitting
