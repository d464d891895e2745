// What a search hands back.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/expansion.hpp"
#include "engine/problem.hpp"
#include "engine/statistics.hpp"
#include "engine/trace.hpp"

namespace kusabi::engine {

template <class P>
struct RankReport {
  RankStatistics statistics;
  TallyOf<P> tally;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& statistics& tally;
  }
};

/// The outcome of a search. On rank 0 it is whole; elsewhere it holds that rank's report only.
template <class P>
struct Outcome {
  Status status = Status::solved;

  /// Nodes that were left open, on all ranks; 0 if solved.
  std::uint64_t open = 0;

  /// Whether all that is needed to go on is in the checkpoint of Options::checkpoint; on rank 0.
  bool saved = false;

  /// For Goal::best: no solution is below this. The objective of the best one if solved, the least
  /// bound of what was left open (or the objective, if smaller) otherwise.
  double bound = -std::numeric_limits<double>::infinity();

  /// All solutions in the order in which a depth-first search on one rank meets them, whatever the
  /// number of ranks was. For Goal::best and Goal::first, the one or none.
  std::vector<Found<P>> solutions;

  /// In the order of the ranks.
  std::vector<RankReport<P>> ranks;

  /// Those of the runs that this one continued from a checkpoint.
  std::vector<RankReport<P>> earlier;

  /// What happened when, in the order of the ranks and on one time axis; on rank 0, and empty
  /// unless `Options::trace_events` asks for it.
  std::vector<RankTrace> traces;

  /// All but the traces, which are of one run.
  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& open& saved& bound& solutions& ranks& earlier;
  }

  /// Nodes opened on all ranks, earlier runs included.
  [[nodiscard]] std::uint64_t opened() const {
    return sum([](const RankStatistics& rank) { return rank.opened; });
  }

  /// What the problems of all ranks have counted, earlier runs included: the sum of their tallies.
  [[nodiscard]] TallyOf<P> tally() const {
    constexpr bool addable = requires(TallyOf<P> & sum, const TallyOf<P>& tally) {
      sum += tally;
    };
    static_assert(addable, "a Tally needs `Tally& operator+=(const Tally& other)` to be summed up");
    TallyOf<P> total{};
    if constexpr (addable) {
      for (const auto& report : earlier) total += report.tally;
      for (const auto& report : ranks) total += report.tally;
    }
    return total;
  }

  /// The mark sum: the sum of the path marks of all opened nodes. Two searches of one tree have
  /// the same one if and only if (but for a chance of 2^-64) both opened the same nodes, each once.
  [[nodiscard]] std::uint64_t fingerprint() const {
    return sum([](const RankStatistics& rank) { return rank.fingerprint; });
  }

 private:
  template <class Value>
  [[nodiscard]] std::uint64_t sum(Value value) const {
    std::uint64_t total = 0;
    for (const auto& report : earlier) total += value(report.statistics);
    for (const auto& report : ranks) total += value(report.statistics);
    return total;
  }
};

}  // namespace kusabi::engine
