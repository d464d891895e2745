// RandomTree: a reproducible random tree whose shape depends on the path hash alone. Most subtrees
// are small and some are very large, as in real searches; opening a node is cheap.
#pragma once

#include <cstdint>

#include "engine/search.hpp"

namespace kusabi::examples {

/// A node at depth < `depth` has 0 to 3 children; one at `depth` has none. About every fourth leaf
/// is a solution; its number is its hash.
class RandomTree {
 public:
  struct Node {
    std::uint64_t state = 0;
    std::uint32_t depth = 0;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& state& depth;
    }
  };
  using Solution = std::uint64_t;
  using Tally = std::uint64_t;

  RandomTree(std::uint64_t seed, std::uint32_t depth) : seed_(seed), depth_(depth) {}

  Node root() const { return {engine::branch_hash(seed_, 0), 0}; }

  void expand(Node&& node, engine::Expansion<RandomTree>& out) { grow(std::move(node), out); }

  /// @param out engine::Expansion of this type, or of one derived from it
  template <class Expansion>
  void grow(Node&& node, Expansion& out) {
    const auto children = node.depth < depth_ ? children_of(node) : 0;
    for (std::uint32_t child = 0; child < children; ++child) {
      out.branch({engine::branch_hash(node.state, child), node.depth + 1});
    }
    if (children != 0) return;
    ++leaves_;
    if ((node.state & 3U) == 0) out.solution(node.state);
  }

  /// Number of leaves opened.
  Tally tally() const { return leaves_; }

 private:
  std::uint32_t children_of(const Node& node) const {
    if (node.depth < 3) return 3;  // no tree ends at once
    return static_cast<std::uint32_t>((node.state >> 40U) & 3U);
  }

  std::uint64_t seed_;
  std::uint32_t depth_;
  std::uint64_t leaves_ = 0;
};

}  // namespace kusabi::examples
