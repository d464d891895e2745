// Where a node is in the tree: the branch numbers from the root down.
//
// A path serves three ends. Its lexicographic order is the order in which a depth-first search on
// one rank meets the nodes, so sorting by it makes every answer independent of the schedule. Its
// 64-bit mark goes into the mark sum of a search, which shows that every node was opened once. And
// it names a node in an error message.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kusabi::engine {

/// Branch numbers from the root (excluded) to a node; the root's path is empty.
using Path = std::vector<std::uint32_t>;

/// The mark of the root. Any odd constant would do; this is 2^64 divided by the golden ratio.
inline constexpr std::uint64_t root_mark = 0x9E3779B97F4A7C15U;

/// What branch number `branch` of a node adds to the mark sum: the first half of a round of
/// Stafford's 64-bit mixer. Sums of marks of two different sets of nodes agree by chance only.
constexpr std::uint64_t branch_mark(std::uint64_t parent_hash, std::uint32_t branch) {
  const std::uint64_t bits = parent_hash + (std::uint64_t{branch} + 1) * root_mark;
  return (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
}

/// The hash of a node, from its mark: the other half. Only nodes with children need it.
constexpr std::uint64_t hash_of_mark(std::uint64_t mark) {
  const std::uint64_t bits = (mark ^ (mark >> 27U)) * 0x94D049BB133111EBU;
  return bits ^ (bits >> 31U);
}

/// The hash of branch number `branch` of a node: the whole round. Also a good source of random
/// numbers that depend on a place in a tree.
constexpr std::uint64_t branch_hash(std::uint64_t parent_hash, std::uint32_t branch) {
  return hash_of_mark(branch_mark(parent_hash, branch));
}

/// "root", or the branch numbers joined by dots: "0.1.1"; of a long path both ends.
std::string to_string(const Path& path);

}  // namespace kusabi::engine
