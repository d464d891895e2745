// RecursiveDoubling: the messages of non-blocking reductions among simulated ranks.
//
// In round k a rank exchanges what it has with the rank whose number differs in bit k, so that
// after log2(ranks) rounds every rank has the sum. If the number of ranks is no power of two, those
// beyond it hand their contribution to a partner first and receive the result from it last. A rank
// enters the next round only when it looks at its messages, as with MPI_Iallreduce: a rank inside a
// node, or asleep, delays all others.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "engine/detail/contract.hpp"
#include "engine/reduction.hpp"

namespace kusabi::engine {

class RecursiveDoubling {
 public:
  explicit RecursiveDoubling(int ranks)
      : ranks_(ranks),
        core_(static_cast<int>(std::bit_floor(static_cast<unsigned>(ranks)))),
        rounds_(static_cast<unsigned>(std::countr_zero(static_cast<unsigned>(core_))) + 2),
        members_(static_cast<std::size_t>(ranks)),
        arrivals_(2 * rounds_ * members_.size(), never) {}

  /// Joins the next wave. @pre the result of the wave before has been taken
  void join(int rank, const Reduction& own) {
    auto& mine = member(rank);
    ensure(!mine.joined, "a rank joins a reduction only after it has fetched the one before");
    mine = {.wave = mine.wave + 1, .joined = true};
    auto& total = totals_[mine.wave % 2];
    if (total.ranks == members_.size()) total = {};  // of the wave before the last
    total.merge(own);
  }

  /// Passes the rounds whose messages have arrived by `now`.
  /// @param send sends a message to a rank and returns its time of arrival
  /// @return number of messages received
  template <class Send>
  unsigned advance(int rank, double now, Send send) {
    unsigned received = 0;
    auto& mine = member(rank);
    while (mine.joined && mine.round < rounds_) {
      if (!std::exchange(mine.sent, true)) {
        if (const auto to = receiver(rank, mine.round)) arrivals_[place_of(*to, mine)] = send(*to);
      }
      if (awaits(rank, mine.round)) {
        auto& arrival = arrivals_[place_of(rank, mine)];
        if (arrival > now) break;
        arrival = never;
        ++received;
      }
      ++mine.round;
      mine.sent = false;
    }
    return received;
  }

  /// True if a rank that looks at this time finds a message or the result.
  [[nodiscard]] bool has_arrived(int rank, double time) const {
    const auto& mine = member(rank);
    if (!mine.joined) return false;
    return mine.round == rounds_ || arrivals_[place_of(rank, mine)] <= time;
  }

  /// Result of the wave that the rank joined, once.
  std::optional<Reduction> take(int rank) {
    auto& mine = member(rank);
    if (!mine.joined || mine.round < rounds_) return std::nullopt;
    mine.joined = false;
    return totals_[mine.wave % 2];
  }

  [[nodiscard]] bool joined(int rank) const { return member(rank).joined; }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  struct Member {
    std::uint64_t wave = 0;
    bool joined = false;
    unsigned round = 0;  // the first and the last are those of ranks beyond the power of two
    bool sent = false;   // the message of this round
  };

  [[nodiscard]] const Member& member(int rank) const {
    return members_[static_cast<std::size_t>(rank)];
  }
  Member& member(int rank) { return members_[static_cast<std::size_t>(rank)]; }

  // A rank may be one wave ahead of another, so there is room for two.
  [[nodiscard]] std::size_t place_of(int to, const Member& sender) const {
    return (2 * static_cast<std::size_t>(to) + sender.wave % 2) * rounds_ + sender.round;
  }

  [[nodiscard]] bool has_partner_beyond(int rank) const { return rank + core_ < ranks_; }

  [[nodiscard]] std::optional<int> receiver(int rank, unsigned round) const {
    if (round == 0) return rank < core_ ? std::nullopt : std::optional(rank - core_);
    if (round + 1 == rounds_) {
      return has_partner_beyond(rank) ? std::optional(rank + core_) : std::nullopt;
    }
    if (rank >= core_) return std::nullopt;
    return rank ^ (1 << (round - 1));
  }

  [[nodiscard]] bool awaits(int rank, unsigned round) const {
    if (round == 0) return has_partner_beyond(rank);
    if (round + 1 == rounds_) return rank >= core_;
    return rank < core_;
  }

  int ranks_;
  int core_;         // greatest power of two among the numbers of ranks
  unsigned rounds_;  // with the first and the last
  std::vector<Member> members_;
  std::vector<double> arrivals_;
  std::array<Reduction, 2> totals_;
};

}  // namespace kusabi::engine
