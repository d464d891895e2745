// Matrix of many columns in blocks of sixteen, four blocks to a group. Each rank has groups of its
// own; sums over columns are formed within each group first and then over the groups in their
// order, so that they are bitwise equal on any number of ranks.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "nodes/limit/splitting/lanes.hpp"

namespace kusabi::limit::splitting {

inline constexpr int lanes = 4;
inline constexpr int block_lanes = 4;
inline constexpr int block_columns = lanes * block_lanes;
inline constexpr int group_blocks = 4;
inline constexpr int group_columns = block_columns * group_blocks;

inline int groups_of(int columns) {
  return (columns + group_columns - 1) / group_columns;
}

/// A row of a block.
struct Segment {
  Lanes part[block_lanes];
};

KUSABI_INLINE double sum_of(const Segment& segment) {
  const auto& part = segment.part;
  return sum_of((part[0] + part[1]) + (part[2] + part[3]));
}

/// The groups of each rank, and the exchange of results between ranks.
struct Sharing {
  int rank = 0;
  int ranks = 1;
  /// Completes numbers of all groups, one group after another, of which those of this rank's groups
  /// are set. Every rank makes the same call. Empty: a single rank.
  std::function<void(std::span<double>)> exchange = {};

  void fill(std::span<double> numbers) const {
    if (exchange) exchange(numbers);
  }
  [[nodiscard]] int first_group_of(int other_rank, int groups) const {
    return groups * other_rank / ranks;
  }
  [[nodiscard]] int first_group(int groups) const { return first_group_of(rank, groups); }
  [[nodiscard]] int end_group(int groups) const { return first_group_of(rank + 1, groups); }
};

/// The columns of this rank, initially zero.
class ColumnBlocks {
 public:
  ColumnBlocks(int rows, int columns, const Sharing& sharing);

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int groups() const { return groups_of(columns_); }
  [[nodiscard]] int first_group() const { return first_; }
  [[nodiscard]] int end_group() const { return end_; }
  [[nodiscard]] int blocks_of(int group) const;

  /// The rows of a block of this rank.
  [[nodiscard]] Segment* block(int group, int number) {
    return numbers_.data() + place(group, number);
  }
  [[nodiscard]] const Segment* block(int group, int number) const {
    return numbers_.data() + place(group, number);
  }

  /// @pre column is of this rank
  [[nodiscard]] double at(int row, int column) const;
  void set(int row, int column, double value);

  [[nodiscard]] std::vector<Segment>& numbers() { return numbers_; }
  [[nodiscard]] const std::vector<Segment>& numbers() const { return numbers_; }

 private:
  [[nodiscard]] std::size_t place(int group, int number) const {
    return static_cast<std::size_t>((group - first_) * group_blocks + number) *
           static_cast<std::size_t>(rows_);
  }

  int rows_;
  int columns_;
  int first_ = 0;
  int end_ = 0;
  std::vector<Segment> numbers_;
};

/// (1 - share) point + share other, replacing the point.
void blend(ColumnBlocks& point, const ColumnBlocks& other, double share);

/// All columns of all ranks, by rows: row i, column j is at i + j * rows. Every rank makes the same
/// call.
std::vector<double> all_columns(const ColumnBlocks& blocks, const Sharing& sharing);

}  // namespace kusabi::limit::splitting
