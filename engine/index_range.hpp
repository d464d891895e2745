// IndexRange: a range of indices as a node of a binary tree. Its children are its halves; its
// leaves have one index.
#pragma once

#include <cstdint>
#include <utility>

namespace kusabi::engine {

/// Indices `first` to `last` - 1.
struct IndexRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;

  [[nodiscard]] std::uint64_t size() const { return last - first; }
  [[nodiscard]] std::pair<IndexRange, IndexRange> halves() const {
    const auto middle = first + size() / 2;
    return {{first, middle}, {middle, last}};
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& first& last;
  }
};

}  // namespace kusabi::engine
