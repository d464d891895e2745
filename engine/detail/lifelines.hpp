// How work finds the ranks that look for it in vain.
//
// When few ranks have work, asking at random is like looking for a needle: of 4096 ranks, one that
// asks every millisecond meets the only busy one after four seconds. So a rank that was refused a
// few times leaves its name with some neighbours, its *lifelines*, and waits; a neighbour that has
// something to spare, now or later, sends it unasked. The neighbours of rank r are r + 1, r + 2,
// r + 4, ... modulo the number of ranks: from any rank to any other it is log2(ranks) hops at most,
// and a rank that waits costs the others log2(ranks) messages and no more.
// (V. Saraswat, P. Kambadur, S. Kodali, D. Grove, S. Krishnamoorthy: Lifeline-based Global Load
// Balancing, PPoPP 2011.)
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "engine/detail/contract.hpp"

namespace kusabi::engine {

/// One rank's lifelines: those that it has left its name with, and the names left with it.
class Lifelines {
 public:
  Lifelines(int self, int ranks) {
    for (long distance = 1; distance < ranks; distance *= 2) {
      neighbours_.push_back({static_cast<int>((self + distance) % ranks), false});
    }
  }

  /// A neighbour that this rank has not left its name with, if there is one.
  [[nodiscard]] std::optional<int> next() const {
    for (const auto& neighbour : neighbours_) {
      if (!neighbour.knows) return neighbour.rank;
    }
    return std::nullopt;
  }

  /// Notes that a neighbour will send something when it can.
  void left_name_with(int rank) { find(rank).knows = true; }

  /// Notes that it has done so, and forgotten the name.
  void served_by(int rank) { find(rank).knows = false; }

  /// Notes another rank's name.
  void remember(int rank) { waiting_.push_back(rank); }

  /// Whether anybody waits for something from this rank.
  [[nodiscard]] bool wanted() const { return !waiting_.empty(); }

  /// The one that has waited longest; it is forgotten.
  /// @pre wanted()
  int take() {
    ensure(wanted(), "a name is taken only if one was left");
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
    ensure(found != neighbours_.end(), "a parcel comes from a lifeline");
    return *found;
  }

  std::vector<Neighbour> neighbours_;
  std::deque<int> waiting_;
};

}  // namespace kusabi::engine
