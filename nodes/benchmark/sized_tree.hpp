// A random tree of a known number of nodes: a load to try the search engine with.
//
// A node knows the size of its subtree, itself included, and deals the rest out to a few children
// in random, very uneven parts; so the tree is deep and unbalanced, and nobody can tell from a node
// how much work lies below it without opening it. The tree depends on its seed and size alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/path.hpp"

namespace kusabi::benchmark {

/// The problem type that engine::search searches.
class SizedTree {
 public:
  struct Node {
    std::uint64_t random = 0;  ///< the source of all that is random about it
    std::uint64_t size = 0;    ///< nodes in its subtree, itself included

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& random& size;
    }
  };

  /// The `random` of a leaf.
  using Solution = std::uint64_t;

  /// @param size nodes of the whole tree, 1 or more
  /// @param solutions one leaf in so many is a solution, on average; 0: none
  SizedTree(std::uint64_t seed, std::uint64_t size, std::uint64_t solutions = 0)
      : root_{engine::branch_hash(seed, 0), size}, solutions_(solutions) {}

  [[nodiscard]] Node root() const { return root_; }

  /// For Goal::best; many leaves have the same, so that ties are tried too.
  [[nodiscard]] double objective(Solution random) const {
    return static_cast<double>(engine::branch_hash(random, 0) % 16);
  }

  /// What a leaf's solution, if it is one, has; 0 of all other nodes.
  [[nodiscard]] double bound(const Node& node) const {
    return node.size == 1 ? objective(node.random) : 0;
  }

  /// @param out engine::Expansion of this type
  template <class Expansion>
  void expand(Node&& node, Expansion& out) const {
    std::uint64_t rest = node.size - 1;
    if (rest == 0) {
      if (solutions_ != 0 && node.random % solutions_ == 0) out.solution(node.random);
      return;
    }
    const auto children = std::min<std::uint64_t>(rest, 2 + node.random % 4);
    for (std::uint64_t child = 0; child < children; ++child) {
      const auto random = engine::branch_hash(node.random, static_cast<std::uint32_t>(child));
      const auto others = children - 1 - child;  // each of them gets one node at least
      const auto part = others == 0 ? rest : 1 + share(random, rest - 1 - others);
      rest -= part;
      out.branch({random, part});
    }
  }

 private:
  // The square of a uniform number: most children get little, some nearly all.
  static std::uint64_t share(std::uint64_t random, std::uint64_t whole) {
    const double uniform = std::ldexp(static_cast<double>(random >> 11U), -53);
    const auto part = static_cast<std::uint64_t>(uniform * uniform * static_cast<double>(whole));
    return std::min(part, whole);
  }

  Node root_;
  std::uint64_t solutions_;
};

}  // namespace kusabi::benchmark
