// UnbalancedTree: the trees of the Unbalanced Tree Search benchmark (S. Olivier, J. Huan, J. Liu,
// J. Prins, J. Dinan, P. Sadayappan, C.-W. Tseng: UTS: An Unbalanced Tree Search Benchmark, LCPC
// 2006).
//
// A node is a 160-bit state. The state of child i is the SHA-1 digest of its parent's state and i,
// and a random number derived from a node's state determines the number of its children. The tree
// is thus unknown before the search, reproducible, and its subtrees have very different sizes,
// which makes load balancing hard. There are no solutions; the published numbers of nodes and
// leaves and the depth verify that a search is complete.
#pragma once

#include <cstdint>
#include <utility>

#include <boost/serialization/array.hpp>

#include "engine/search_declaration.hpp"
#include "support/sha1.hpp"

namespace kusabi::benchmark {

/// Distribution of the number of children.
enum class TreeType {
  binomial,   ///< m children with probability q, else none; the root has b
  geometric,  ///< geometric, with a mean that depends on the depth: see TreeShape
  hybrid,     ///< geometric above half of the depth d, binomial below
};

/// Mean number of children at a depth h > 0 of a geometric tree; at the root it is b.
enum class TreeShape {
  linear,       ///< b (1 - h/d)
  exponential,  ///< b h^(-log b / log d), which is 1 at depth d
  cyclic,       ///< b^sin(2 pi h / d), and 0 below depth 5 d
  fixed,        ///< b above depth d, 0 below
};

/// Parameters of a tree, with the letters of the benchmark's options.
struct TreeParameters {
  TreeType type = TreeType::geometric;  ///< -t
  TreeShape shape = TreeShape::linear;  ///< -a, of a geometric or hybrid tree
  double branching = 4;                 ///< -b
  std::uint32_t depth = 6;              ///< -d, of a geometric or hybrid tree
  double probability = 0;               ///< -q, of a binomial or hybrid tree
  std::uint32_t binomial_children = 0;  ///< -m, of a binomial or hybrid tree
  std::uint32_t seed = 0;               ///< -r
};

/// Counts of a tree.
struct TreeCounts {
  std::uint64_t nodes = 0;
  std::uint64_t leaves = 0;  ///< nodes without children
  std::uint64_t depth = 0;   ///< of the deepest node; the root has depth 0

  friend bool operator==(const TreeCounts&, const TreeCounts&) = default;

  /// Adds the counts of another part of the same tree.
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

/// The tree as a problem of engine::search.
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

  /// There are no solutions.
  struct Solution {
    template <class Archive>
    void serialize(Archive& /*archive*/, unsigned /*version*/) {}
  };

  using Tally = TreeCounts;

  /// @param work number of times that a child's state is computed; above 1 nodes cost more
  explicit UnbalancedTree(const TreeParameters& parameters, unsigned work = 1)
      : parameters_(parameters), work_(work) {}

  Node root() const {
    return {support::sha1(std::array<std::uint32_t, 5>{0, 0, 0, 0, parameters_.seed}), 0};
  }

  /// Number of children of a node; at most 100, except at the root of a binomial tree.
  [[nodiscard]] std::uint32_t children(const Node& node) const;

  /// Child number `number` of a node, from 0.
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

  /// Counts of the nodes expanded by this object.
  [[nodiscard]] Tally tally() const { return seen_; }

 private:
  TreeParameters parameters_;
  unsigned work_;
  Tally seen_;
};

}  // namespace kusabi::benchmark

extern template kusabi::engine::OutcomeOf<kusabi::benchmark::UnbalancedTree> kusabi::engine::search(
    kusabi::benchmark::UnbalancedTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
