// A range of numbers as a node of a tree: its children are its halves, its leaves ranges of one
// number.
#pragma once

#include <cstdint>
#include <utility>

namespace kusabi::engine {

/// `first` to `last` - 1.
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
