// The trees of the Unbalanced Tree Search benchmark (S. Olivier, J. Huan, J. Liu, J. Prins, J.
// Dinan, P. Sadayappan, C.-W. Tseng: UTS: An Unbalanced Tree Search Benchmark, LCPC 2006).
//
// A node is a 160-bit state. The state of child i is the SHA-1 digest of its parent's state and i,
// and a random number drawn from a node's state says how many children it has. So the tree is known
// to nobody before it is searched, it is the same for everybody, and its subtrees differ in size as
// much as chance can make them: the hardest thing to share fairly. Nothing is searched for; the
// nodes, the leaves and the depth, which are published, tell whether a search saw them all.
#pragma once

#include <cstdint>
#include <utility>

#include <boost/serialization/array.hpp>

#include "support/sha1.hpp"

namespace kusabi::benchmark {

/// How the number of children depends on a node.
enum class TreeType {
  binomial,   ///< m children with probability q, else none; the root has b
  geometric,  ///< geometrically distributed, with a mean that depends on the depth: see TreeShape
  hybrid,     ///< geometric above half of the depth d, binomial from there on
};

/// The mean number of children at a depth h > 0 of a geometric tree; at the root it is b.
enum class TreeShape {
  linear,       ///< b (1 - h/d)
  exponential,  ///< b h^(-log b / log d), which is 1 at depth d
  cyclic,       ///< b^sin(2 pi h / d), and 0 below depth 5 d
  fixed,        ///< b above depth d, 0 from there on
};

/// What defines a tree, with the letters of the benchmark's options.
struct TreeParameters {
  TreeType type = TreeType::geometric;  ///< -t
  TreeShape shape = TreeShape::linear;  ///< -a, of a geometric or hybrid tree
  double branching = 4;                 ///< -b
  std::uint32_t depth = 6;              ///< -d, of a geometric or hybrid tree
  double probability = 0;               ///< -q, of a binomial or hybrid tree
  std::uint32_t binomial_children = 0;  ///< -m, of a binomial or hybrid tree
  std::uint32_t seed = 0;               ///< -r
};

/// What there is to know about a tree.
struct TreeCounts {
  std::uint64_t nodes = 0;
  std::uint64_t leaves = 0;  ///< nodes without children
  std::uint64_t depth = 0;   ///< of the deepest node; the root has depth 0

  friend bool operator==(const TreeCounts&, const TreeCounts&) = default;

  /// Adds what was counted in another part of the same tree.
  TreeCounts& operator+=(const TreeCounts& other) {
    nodes += other.nodes;
    leaves += other.leaves;
    if (other.depth > depth) depth = other.depth;
    return *this;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& nodes& leaves& depth;
  }
};

/// The problem type that engine::search searches.
class UnbalancedTree {
 public:
  struct Node {
    support::Sha1Digest state{};
    std::uint32_t depth = 0;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& state& depth;
    }
  };

  /// Never reported.
  struct Solution {
    template <class Archive>
    void serialize(Archive& /*archive*/, unsigned /*version*/) {}
  };

  using Tally = TreeCounts;

  /// @param work how often a child's state is computed; above 1 it only makes nodes more expensive
  explicit UnbalancedTree(const TreeParameters& parameters, unsigned work = 1)
      : parameters_(parameters), work_(work) {}

  Node root() const {
    return {support::sha1(std::array<std::uint32_t, 5>{0, 0, 0, 0, parameters_.seed}), 0};
  }

  /// How many children a node has; at most 100, but for the root of a binomial tree.
  [[nodiscard]] std::uint32_t children(const Node& node) const;

  /// Child number `number` of a node, the first being 0.
  [[nodiscard]] Node child(const Node& parent, std::uint32_t number) const {
    const auto& s = parent.state;
    const std::array<std::uint32_t, 6> message{s[0], s[1], s[2], s[3], s[4], number};
    Node child{support::sha1(message), parent.depth + 1};
    for (unsigned round = 1; round < work_; ++round) child.state = support::sha1(message);
    return child;
  }

  /// @param out engine::Expansion of this type, or of one that wraps it
  template <class Expansion>
  void expand(Node&& node, Expansion& out) {
    const auto count = children(node);
    seen_ += {1, count == 0 ? 1U : 0U, node.depth};
    for (std::uint32_t number = 0; number < count; ++number) out.branch(child(node, number));
  }

  /// What this object has expanded.
  [[nodiscard]] Tally tally() const { return seen_; }

 private:
  TreeParameters parameters_;
  unsigned work_;
  Tally seen_;
};

}  // namespace kusabi::benchmark
