// SizedTree: a random tree with a given number of nodes, to test the search engine.
//
// A node stores the size of its subtree, itself included, and distributes the rest to a few
// children in random, very unequal parts. The tree is therefore deep and unbalanced. It depends on
// its seed and size alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/path.hpp"

namespace kusabi::benchmark {

/// The tree as a problem of engine::search.
class SizedTree {
 public:
  struct Node {
    std::uint64_t random = 0;  ///< random number from which all others derive
    std::uint64_t size = 0;    ///< number of nodes in its subtree, itself included

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& random& size;
    }
  };

  /// The `random` of a leaf.
  using Solution = std::uint64_t;

  /// @param size number of nodes, 1 or more
  /// @param solutions one leaf in so many is a solution, on average; 0: none
  SizedTree(std::uint64_t seed, std::uint64_t size, std::uint64_t solutions = 0)
      : root_{engine::branch_hash(seed, 0), size}, solutions_(solutions) {}

  [[nodiscard]] Node root() const { return root_; }

  /// Objective for Goal::best; many leaves have equal objectives, to test their order.
  [[nodiscard]] double objective(Solution random) const {
    return static_cast<double>(engine::branch_hash(random, 0) % 16);
  }

  /// Lower bound: the objective of a leaf; 0 for all other nodes.
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
      const auto others = children - 1 - child;  // each gets one node at least
      const auto part = others == 0 ? rest : 1 + share(random, rest - 1 - others);
      rest -= part;
      out.branch({random, part});
    }
  }

 private:
  // Square of a uniform number: most children get a small part, some nearly all.
  static std::uint64_t share(std::uint64_t random, std::uint64_t whole) {
    const double uniform = std::ldexp(static_cast<double>(random >> 11U), -53);
    const auto part = static_cast<std::uint64_t>(uniform * uniform * static_cast<double>(whole));
    return std::min(part, whole);
  }

  Node root_;
  std::uint64_t solutions_;
};

}  // namespace kusabi::benchmark
