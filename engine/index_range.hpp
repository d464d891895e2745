// IndexRange: a range of indices as a node of a binary tree. Its children are its halves; its
// leaves have one index.
#pragma once

#include <cstdint>

namespace kusabi::engine {

/// Indices `first` to `last` - 1.
struct IndexRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;

  [[nodiscard]] std::uint64_t size() const { return last - first; }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& first& last;
  }
};

/// Branches a range of more than `maximum` indices into its halves.
/// @return true if the range was branched; otherwise the caller processes it
/// @tparam Expansion that of a problem whose nodes are ranges
template <class Expansion>
bool branch_into_halves(const IndexRange& range, std::uint64_t maximum, Expansion& out) {
  if (range.size() <= maximum) return false;
  const auto middle = range.first + range.size() / 2;
  out.branch(IndexRange{range.first, middle});
  out.branch(IndexRange{middle, range.last});
  return true;
}

}  // namespace kusabi::engine
