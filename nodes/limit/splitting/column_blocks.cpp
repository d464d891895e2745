// Indices in memory.
#include "nodes/limit/splitting/column_blocks.hpp"

#include <algorithm>

namespace kusabi::limit::splitting {

ColumnBlocks::ColumnBlocks(int rows, int columns, const Sharing& sharing)
    : rows_(rows), columns_(columns) {
  first_ = sharing.first_group(groups());
  end_ = sharing.end_group(groups());
  const auto blocks = static_cast<std::size_t>(std::max(0, end_ - first_) * group_blocks);
  numbers_.assign(blocks * static_cast<std::size_t>(rows), Segment{});
}

int ColumnBlocks::blocks_of(int group) const {
  const int left = columns_ - group * group_columns;
  return std::min(group_blocks, (left + block_columns - 1) / block_columns);
}

double ColumnBlocks::at(int row, int column) const {
  const int within = column % group_columns;
  const auto& segment =
      block(column / group_columns, within / block_columns)[static_cast<std::size_t>(row)];
  return segment.part[within % block_columns / lanes][within % lanes];
}

void ColumnBlocks::set(int row, int column, double value) {
  const int within = column % group_columns;
  auto& segment =
      block(column / group_columns, within / block_columns)[static_cast<std::size_t>(row)];
  segment.part[within % block_columns / lanes][within % lanes] = value;
}

void blend(ColumnBlocks& point, const ColumnBlocks& other, double share) {
  for (std::size_t k = 0; k < point.numbers().size(); ++k) {
    for (int h = 0; h < block_lanes; ++h) {
      auto& own = point.numbers()[k].part[h];
      own = (1 - share) * own + share * other.numbers()[k].part[h];
    }
  }
}

std::vector<double> all_columns(const ColumnBlocks& blocks, const Sharing& sharing) {
  const auto rows = static_cast<std::size_t>(blocks.rows());
  std::vector<double> all(rows * group_columns * static_cast<std::size_t>(blocks.groups()));
  const int end = std::min(blocks.columns(), blocks.end_group() * group_columns);
  for (int j = blocks.first_group() * group_columns; j < end; ++j) {
    for (int i = 0; i < blocks.rows(); ++i) {
      all[static_cast<std::size_t>(i) + rows * static_cast<std::size_t>(j)] = blocks.at(i, j);
    }
  }
  sharing.fill(all);
  all.resize(rows * static_cast<std::size_t>(blocks.columns()));
  return all;
}

}  // namespace kusabi::limit::splitting
