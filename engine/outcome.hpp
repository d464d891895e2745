// Outcome: the result of a search.
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

/// Outcome of a search. It is complete on rank 0; on other ranks it holds only their own report.
template <class P>
struct Outcome {
  Status status = Status::solved;

  /// Number of open nodes left, on all ranks; 0 if solved.
  std::uint64_t open = 0;

  /// True on rank 0 if the checkpoint of Options::checkpoint suffices to resume.
  bool saved = false;

  /// For Goal::best: bound of the objective of all solutions. The objective of the best one if
  /// solved (Options::cutoff if there is none as good); otherwise the best bound of the open nodes
  /// left, or the objective if that is better.
  double bound = -std::numeric_limits<double>::infinity();

  /// All solutions in depth-first order, for any number of ranks. For Goal::first at most one; for
  /// Goal::best those of Options::pool, the best first and equal ones in depth-first order.
  std::vector<FoundSolution<P>> solutions;

  /// Reports in the order of the ranks.
  std::vector<RankReport<P>> ranks;

  /// Reports of the runs from which this one resumed.
  std::vector<RankReport<P>> earlier;

  /// Traces in the order of the ranks and on one time axis; on rank 0, and empty unless
  /// `Options::trace_events` is set.
  std::vector<RankTrace> traces;

  /// Serialises everything but the traces, which belong to one run.
  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& open& saved& bound& solutions& ranks& earlier;
  }

  /// Statistics of all ranks together, earlier runs included.
  [[nodiscard]] RankStatistics total() const {
    RankStatistics total;
    for (const auto& report : earlier) total += report.statistics;
    for (const auto& report : ranks) total += report.statistics;
    return total;
  }

  /// Number of nodes opened on all ranks, earlier runs included.
  [[nodiscard]] std::uint64_t opened() const { return total().opened; }

  /// Sum of the tallies of all ranks, earlier runs included.
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

  /// Mark sum: the sum of the path marks of all opened nodes. Two searches of one tree have the
  /// same mark sum if and only if (except with probability 2^-64) both opened the same nodes, each
  /// once.
  [[nodiscard]] std::uint64_t fingerprint() const { return total().fingerprint; }
};

}  // namespace kusabi::engine
