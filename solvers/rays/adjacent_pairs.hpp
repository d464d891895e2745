// Which pairs of rays on the two sides of a step are adjacent, by bits alone: two bit pattern trees
// are descended together, and a pair of parts that cannot hold an adjacent pair is left out whole.
//
// Most pairs that share enough equalities are not adjacent, and a third ray on their face shows it.
// It often shows the same of the next pairs, so the last such rays are tried before the tree of all
// rays is searched.
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

  /// @param rays all of the list, which must outlive this
  /// @param plus, minus the numbers of those on either side; neither is empty
  /// @param processed the candidates at which rays must be cross-complementary
  /// @param enough equalities that two adjacent rays share at least: 2m - 2
  AdjacentPairs(std::span<const ZeroSet> rays, const std::vector<int>& plus,
                const std::vector<int>& minus, Candidates processed, int enough);

  Part whole() const { return {&plus_.root(), &minus_.root()}; }

  /// Parts that together are the whole, in its order, of at most so many pairs each unless they are
  /// pairs of leaves. Those without adjacent pairs may be missing.
  std::vector<Part> parts(std::uint64_t most_pairs) const;

  /// Calls `found` for each adjacent pair of a part.
  /// @param stop asked now and then whether to end; empty: never  @return false if it said so
  bool search(const Part& part, const std::function<void(const AdjacentPair&)>& found,
              const std::function<bool()>& stop, std::uint64_t& looked_at) const;

 private:
  class Descent;

  bool may_be_adjacent(const Pattern& common) const {
    return (processed_ & ~(common.zero.u | common.r)) == 0 && size(common.zero) >= enough_;
  }
  /// The two parts that a part consists of; none of a pair of leaves.
  std::vector<Part> halves(const Part& part) const;

  BitPatternTree plus_;
  BitPatternTree minus_;
  BitPatternTree all_;
  std::span<const ZeroSet> rays_;
  Candidates processed_;
  int enough_;
};

}  // namespace kusabi::rays
