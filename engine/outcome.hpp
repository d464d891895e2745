// What a search hands back.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/expansion.hpp"
#include "engine/problem.hpp"

namespace kusabi::engine {

/// What one rank did.
struct RankStatistics {
  std::uint64_t opened = 0;          ///< nodes opened here
  std::uint64_t fingerprint = 0;     ///< sum of the hashes of their paths, modulo 2^64
  std::uint64_t found = 0;           ///< solutions found here
  std::uint64_t peak_open = 0;       ///< most nodes that were waiting at one time
  std::uint64_t requests = 0;        ///< times it asked for work
  std::uint64_t gifts_received = 0;  ///< times it was given some
  std::uint64_t gifts_sent = 0;      ///< times it gave some
  std::uint64_t nodes_given = 0;     ///< nodes in those
  double idle_seconds = 0;           ///< time without an open node
  double seconds = 0;                ///< time from the start to the end of the search

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& opened& fingerprint& found& peak_open& requests& gifts_received& gifts_sent;
    archive& nodes_given& idle_seconds& seconds;
  }
};

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
  /// All solutions in the order in which a depth-first search on one rank meets them, whatever the
  /// number of ranks was.
  std::vector<Found<P>> solutions;

  /// In the order of the ranks.
  std::vector<RankReport<P>> ranks;

  /// Nodes opened on all ranks.
  [[nodiscard]] std::uint64_t opened() const {
    std::uint64_t sum = 0;
    for (const auto& report : ranks) sum += report.statistics.opened;
    return sum;
  }

  /// The sum of the path hashes of all opened nodes: equal for two searches of one tree if and only
  /// if (but for a chance of 2^-64) both opened the same nodes, each once.
  [[nodiscard]] std::uint64_t fingerprint() const {
    std::uint64_t sum = 0;
    for (const auto& report : ranks) sum += report.statistics.fingerprint;
    return sum;
  }
};

}  // namespace kusabi::engine
