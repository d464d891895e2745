// Where a node hangs in the tree: the branch numbers from the root down.
//
// A path serves three ends. Its lexicographic order is the order in which a depth-first search on
// one rank meets the nodes, so sorting by it makes every answer independent of the schedule. Its
// 64-bit hash goes into the fingerprint of a search. And it names a node in an error message.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kusabi::engine {

/// Branch numbers from the root (excluded) to a node; the root's path is empty.
using Path = std::vector<std::uint32_t>;

/// The hash of the root. Any odd constant would do; this is 2^64 divided by the golden ratio.
inline constexpr std::uint64_t root_hash = 0x9E3779B97F4A7C15U;

/// The hash of branch number `branch` of a node: one round of Stafford's 64-bit mixer, after which
/// the sums of hashes of two different sets of nodes agree with probability 2^-64 only.
constexpr std::uint64_t branch_hash(std::uint64_t parent, std::uint32_t branch) {
  std::uint64_t bits = parent + (std::uint64_t{branch} + 1) * root_hash;
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
  return bits ^ (bits >> 31U);
}

/// "root", or the branch numbers joined by dots: "0.1.1"; of a long path both ends.
std::string to_string(const Path& path);

}  // namespace kusabi::engine
