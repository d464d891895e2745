// Sets of bits in a tree, each inner node of which knows the union of what is below it: whether any
// of many zero sets can contain a given one is seen near the root (M. Terzer and J. Stelling,
// Large-scale computation of elementary flux modes with bit pattern trees, Bioinformatics 24,
// 2008).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "solvers/rays/zero_set.hpp"

namespace kusabi::rays {

/// A zero set, and `r`: where p and q are both zero (of a union: where they are in one of its
/// sets).
struct Pattern {
  ZeroSet zero;
  Candidates r = 0;
};

inline Pattern pattern_of(const ZeroSet& zero) {
  return {zero, zero.p & zero.q};
}

inline ZeroSet common(const ZeroSet& a, const ZeroSet& b) {
  return {a.p & b.p, a.q & b.q, a.u & b.u};
}

inline Pattern common(const Pattern& a, const Pattern& b) {
  return {common(a.zero, b.zero), a.r & b.r};
}

inline bool contains(const ZeroSet& larger, const ZeroSet& smaller) {
  return ((smaller.p & ~larger.p) | (smaller.q & ~larger.q) | (smaller.u & ~larger.u)) == 0;
}

class BitPatternTree {
 public:
  /// A part of the tree: the members from `first` on, before `last`, split into `left` and
  /// `left + 1` unless left < 0.
  struct Node {
    Pattern all;  ///< the union of the zero sets below
    int first;
    int last;
    int left;

    bool is_leaf() const { return left < 0; }
    int size() const { return last - first; }
  };

  /// @param sets what the members are numbers of
  BitPatternTree(std::span<const ZeroSet> sets, std::vector<int> members);

  const Node& root() const { return nodes_.front(); }
  const Node& child(const Node& node, int which) const {
    return nodes_[static_cast<std::size_t>(node.left + which)];
  }
  /// The pattern and the number of the member at a place between a node's `first` and `last`.
  const Pattern& pattern(int place) const { return patterns_[static_cast<std::size_t>(place)]; }
  int member(int place) const { return members_[static_cast<std::size_t>(place)]; }

  /// The number of a member that contains `smaller`, but for two; nothing if there is none.
  std::optional<int> superset(const ZeroSet& smaller, std::array<int, 2> but_for) const;

 private:
  void grow(std::span<const ZeroSet> sets, std::size_t node);
  std::optional<int> superset(const Node& node, const ZeroSet& smaller,
                              const std::array<int, 2>& but_for) const;

  std::vector<int> members_;
  std::vector<Pattern> patterns_;  // of the members, side by side as they are looked at
  std::vector<Node> nodes_;
};

}  // namespace kusabi::rays
