// Lifelines: work distribution to ranks whose requests have failed.
//
// Random requests are slow when few ranks have work: of 4096 ranks, one that asks every millisecond
// reaches the only busy one after four seconds on average. A rank whose requests were refused a few
// times therefore registers with some neighbours, its *lifelines*, and waits; a neighbour that has
// nodes to spare, now or later, sends them unasked. The lifelines of rank r are r + 1, r + 2, r +
// 4, ... modulo the number of ranks: any rank reaches any other in at most log2(ranks) hops, and a
// waiting rank costs the others at most log2(ranks) messages. (V. Saraswat, P. Kambadur, S. Kodali,
// D. Grove, S. Krishnamoorthy: Lifeline-based Global Load Balancing, PPoPP 2011.) Ranks that begin
// without nodes are registered with all their lifelines from the start, without a message.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "engine/detail/contract.hpp"

namespace kusabi::engine {

/// Lifelines of one rank: those with which it registers, and the ranks registered with it.
class Lifelines {
 public:
  Lifelines(int self, int ranks) {
    for (long distance = 1; distance < ranks; distance *= 2) {
      neighbours_.push_back({static_cast<int>((self + distance) % ranks), State::unaware});
    }
  }

  /// Registers the ranks from `first` on, which begin without nodes, with their lifelines.
  void register_idle(int first, int self, int ranks) {
    for (auto& neighbour : neighbours_) {
      if (self >= first) neighbour.state = State::aware;
    }
    aware_ = self >= first ? neighbours_.size() : 0;
    for (long distance = 1; distance < ranks; distance *= 2) {
      const int other = static_cast<int>((self - distance + ranks) % ranks);
      if (other >= first) remember(other);
    }
  }

  /// True if this rank is registered with all its lifelines.
  [[nodiscard]] bool all_aware() const { return aware_ == neighbours_.size(); }
  /// Number of lifelines with which it is registered.
  [[nodiscard]] std::size_t aware() const { return aware_; }

  /// True if a lifeline has not answered yet.
  [[nodiscard]] bool asking() const { return asked_ > 0; }
  [[nodiscard]] bool asking(int rank) const {
    return std::any_of(neighbours_.begin(), neighbours_.end(), [&](const Neighbour& neighbour) {
      return neighbour.rank == rank && neighbour.is_asked();
    });
  }

  /// The next lifeline to ask: the first with which this rank is not registered and that has no
  /// request of it; nothing if there is none.
  std::optional<int> ask_next() {
    for (auto& neighbour : neighbours_) {
      if (neighbour.state != State::unaware) continue;
      neighbour.state = State::asked;
      ++asked_;
      return neighbour.rank;
    }
    return std::nullopt;
  }

  /// Records that a lifeline that was asked refused, and remembers this rank. (Messages with
  /// different tags may overtake each other: if nodes have come from it meanwhile, it has forgotten
  /// this rank again.)
  void refused_by(int rank) {
    auto& neighbour = find(rank);
    const bool remembers = neighbour.state == State::asked;
    --asked_;
    neighbour.state = remembers ? State::aware : State::unaware;
    if (remembers) ++aware_;
  }

  /// Records that a lifeline that was asked gave at once.
  void given_by(int rank) {
    find(rank).state = State::unaware;
    --asked_;
  }

  /// Records that a lifeline has sent nodes unasked, which ends the registration.
  void served_by(int rank) {
    auto& neighbour = find(rank);
    if (neighbour.state == State::aware) --aware_;
    neighbour.state = neighbour.is_asked() ? State::served : State::unaware;
  }

  /// Records the registration of another rank.
  void remember(int rank) { waiting_.push_back(rank); }

  /// True if a rank is registered here.
  [[nodiscard]] bool has_registered() const { return !waiting_.empty(); }

  /// Removes and returns the rank that has been registered longest.
  /// @pre has_registered()
  int take() {
    ensure(has_registered(), "a rank is taken only if one is registered");
    const int rank = waiting_.front();
    waiting_.pop_front();
    return rank;
  }

 private:
  enum class State {
    unaware,
    asked,   // has not answered yet
    served,  // as asked, but nodes from it have overtaken the answer
    aware
  };

  struct Neighbour {
    int rank;
    State state;
    [[nodiscard]] bool is_asked() const { return state == State::asked || state == State::served; }
  };

  Neighbour& find(int rank) {
    const auto found =
        std::find_if(neighbours_.begin(), neighbours_.end(),
                     [&](const Neighbour& neighbour) { return neighbour.rank == rank; });
    ensure(found != neighbours_.end(), "a lifeline transfer comes from a lifeline");
    return *found;
  }

  std::vector<Neighbour> neighbours_;
  std::size_t aware_ = 0;
  std::size_t asked_ = 0;
  std::deque<int> waiting_;
};

}  // namespace kusabi::engine
