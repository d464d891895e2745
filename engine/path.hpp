// Path: the branch numbers from the root down to a node.
//
// A path has three uses. Its lexicographic order is the order in which a depth-first search on one
// rank visits the nodes; sorting by it makes the answer independent of the schedule. Its 64-bit
// mark is added to the mark sum of a search, which shows that every node was opened once. It names
// a node in an error message.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kusabi::engine {

/// Branch numbers from the root (excluded) to a node; the root's path is empty.
using Path = std::vector<std::uint32_t>;

/// Mark of the root: 2^64 divided by the golden ratio (any odd constant would do).
inline constexpr std::uint64_t root_mark = 0x9E3779B97F4A7C15U;

/// Contribution of branch number `branch` of a node to the mark sum: the first half of a round of
/// Stafford's 64-bit mixer. Mark sums of different sets of nodes agree by chance only.
constexpr std::uint64_t branch_mark(std::uint64_t parent_hash, std::uint32_t branch) {
  const std::uint64_t bits = parent_hash + (std::uint64_t{branch} + 1) * root_mark;
  return (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
}

/// Hash of a node, from its mark: the second half of the round. Only nodes with children need it.
constexpr std::uint64_t hash_of_mark(std::uint64_t mark) {
  const std::uint64_t bits = (mark ^ (mark >> 27U)) * 0x94D049BB133111EBU;
  return bits ^ (bits >> 31U);
}

/// Hash of branch number `branch` of a node: the whole round. It also serves as a random number
/// that depends on the position in a tree.
constexpr std::uint64_t branch_hash(std::uint64_t parent_hash, std::uint32_t branch) {
  return hash_of_mark(branch_mark(parent_hash, branch));
}

/// "root", or the branch numbers joined by dots: "0.1.1"; a long path is shortened in the middle.
std::string to_string(const Path& path);

}  // namespace kusabi::engine
