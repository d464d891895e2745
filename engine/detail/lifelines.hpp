// Lifelines: work distribution to ranks whose requests have failed.
//
// Random requests are slow when few ranks have work: of 4096 ranks, one that asks every millisecond
// reaches the only busy one after four seconds on average. A rank whose requests were refused a few
// times therefore registers with some neighbours, its *lifelines*, and waits; a neighbour that has
// nodes to spare, now or later, sends them unasked. The lifelines of rank r are r + 1, r + 2, r +
// 4, ... modulo the number of ranks: any rank reaches any other in at most log2(ranks) hops, and a
// waiting rank costs the others at most log2(ranks) messages. (V. Saraswat, P. Kambadur, S. Kodali,
// D. Grove, S. Krishnamoorthy: Lifeline-based Global Load Balancing, PPoPP 2011.)
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "engine/detail/contract.hpp"

namespace kusabi::engine {

/// Lifelines of one rank: those with which it has registered, and the ranks registered with it.
class Lifelines {
 public:
  Lifelines(int self, int ranks) {
    for (long distance = 1; distance < ranks; distance *= 2) {
      neighbours_.push_back({static_cast<int>((self + distance) % ranks), false});
    }
  }

  /// A lifeline with which this rank is not registered, if there is one.
  [[nodiscard]] std::optional<int> next() const {
    for (const auto& neighbour : neighbours_) {
      if (!neighbour.knows) return neighbour.rank;
    }
    return std::nullopt;
  }

  /// Records the registration with a lifeline.
  void left_name_with(int rank) { find(rank).knows = true; }

  /// Records that a lifeline has sent nodes, which ends the registration.
  void served_by(int rank) { find(rank).knows = false; }

  /// Records the registration of another rank.
  void remember(int rank) { waiting_.push_back(rank); }

  /// True if a rank is registered here.
  [[nodiscard]] bool wanted() const { return !waiting_.empty(); }

  /// Removes and returns the rank that has been registered longest.
  /// @pre wanted()
  int take() {
    ensure(wanted(), "a rank is taken only if one is registered");
    const int rank = waiting_.front();
    waiting_.pop_front();
    return rank;
  }

 private:
  struct Neighbour {
    int rank;
    bool knows;
  };

  Neighbour& find(int rank) {
    const auto found =
        std::find_if(neighbours_.begin(), neighbours_.end(),
                     [&](const Neighbour& neighbour) { return neighbour.rank == rank; });
    ensure(found != neighbours_.end(), "a lifeline transfer comes from a lifeline");
    return *found;
  }

  std::vector<Neighbour> neighbours_;
  std::deque<int> waiting_;
};

}  // namespace kusabi::engine
