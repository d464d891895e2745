// AdjacentPairs: adjacent pairs of rays on the two sides of a step, by bit operations: two bit
// pattern trees are descended together, and a pair of subtrees that cannot contain an adjacent pair
// is skipped.
//
// Most pairs that share enough equalities are not adjacent, which a third ray on their face proves.
// The same ray often applies to the next pairs, so the most recent ones are tried before the tree
// of all rays is searched.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "solvers/rays/bit_pattern_tree.hpp"
#include "solvers/rays/zero_set.hpp"

namespace kusabi::rays {

struct AdjacentPair {
  int plus;
  int minus;
  ZeroSet common;  ///< equalities of both
};

class AdjacentPairs {
 public:
  /// A part of the search: the pairs of one node of each tree.
  struct Part {
    const BitPatternTree::Node* plus;
    const BitPatternTree::Node* minus;
  };

  /// @param rays the whole list, which must outlive this
  /// @param plus, minus indices of the rays on either side; neither is empty
  /// @param processed the candidates at which rays must be cross-complementary
  /// @param enough minimum number of shared equalities of two adjacent rays: 2m - 2
  AdjacentPairs(std::span<const ZeroSet> rays, const std::vector<int>& plus,
                const std::vector<int>& minus, Candidates processed, int enough);

  Part whole() const { return {&plus_.root(), &minus_.root()}; }

  /// Partition of the search, in its order, into parts of at most `max_pairs` pairs each unless
  /// they are pairs of leaves. Parts without adjacent pairs may be omitted.
  std::vector<Part> parts(std::uint64_t max_pairs) const;

  /// Calls `found` for each adjacent pair of a part.
  /// @param stop called now and then; empty: never
  /// @param tested increased by the number of pairs tested individually
  /// @return false if `stop` returned true
  bool search(const Part& part, const std::function<void(const AdjacentPair&)>& found,
              const std::function<bool()>& stop, std::uint64_t& tested) const;

 private:
  class Descent;

  bool may_be_adjacent(const BitPattern& common) const {
    return (processed_ & ~(common.zero.u | common.r)) == 0 && size(common.zero) >= enough_;
  }
  /// The two halves of a part; none for a pair of leaves.
  std::vector<Part> halves(const Part& part) const;

  BitPatternTree plus_;
  BitPatternTree minus_;
  BitPatternTree all_;
  std::span<const ZeroSet> rays_;
  Candidates processed_;
  int enough_;
};

}  // namespace kusabi::rays
