// BitPatternTree: sets of bits in a tree whose inner nodes store the union of the sets below, for
// superset queries (M. Terzer and J. Stelling, Large-scale computation of elementary flux modes
// with bit pattern trees, Bioinformatics 24, 2008).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "solvers/rays/zero_set.hpp"

namespace kusabi::rays {

/// A zero set, and `r`: the candidates where p and q are both zero (in a union: in one of its
/// sets).
struct BitPattern {
  ZeroSet zero;
  Candidates r = 0;
};

inline BitPattern pattern_of(const ZeroSet& zero) {
  return {zero, zero.p & zero.q};
}

inline ZeroSet common(const ZeroSet& a, const ZeroSet& b) {
  return {a.p & b.p, a.q & b.q, a.u & b.u};
}

inline BitPattern common(const BitPattern& a, const BitPattern& b) {
  return {common(a.zero, b.zero), a.r & b.r};
}

inline bool contains(const ZeroSet& larger, const ZeroSet& smaller) {
  return ((smaller.p & ~larger.p) | (smaller.q & ~larger.q) | (smaller.u & ~larger.u)) == 0;
}

class BitPatternTree {
 public:
  /// A subtree: the members `first` to `last` - 1, split into `left` and `left + 1` unless left <
  /// 0.
  struct Node {
    BitPattern all;  ///< union of the zero sets below
    int first;
    int last;
    int left;

    bool is_leaf() const { return left < 0; }
    int size() const { return last - first; }
  };

  /// @param sets indexed by the members
  BitPatternTree(std::span<const ZeroSet> sets, std::vector<int> members);

  const Node& root() const { return nodes_.front(); }
  const Node& child(const Node& node, int which) const {
    return nodes_[static_cast<std::size_t>(node.left + which)];
  }
  /// Pattern and index of the member at a position between a node's `first` and `last`.
  const BitPattern& pattern(int place) const { return patterns_[static_cast<std::size_t>(place)]; }
  int member(int place) const { return members_[static_cast<std::size_t>(place)]; }

  /// Index of a member that contains `smaller`, except the two in `except`; nothing if there is
  /// none.
  std::optional<int> superset(const ZeroSet& smaller, std::array<int, 2> except) const;

 private:
  void grow(std::span<const ZeroSet> sets, std::size_t node);
  std::optional<int> superset(const Node& node, const ZeroSet& smaller,
                              const std::array<int, 2>& except) const;

  std::vector<int> members_;
  std::vector<BitPattern> patterns_;  // of the members, in the order of the tree
  std::vector<Node> nodes_;
};

}  // namespace kusabi::rays
