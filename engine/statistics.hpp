// Statistics and status of a search, independent of the problem.
#pragma once

#include <cstdint>

namespace kusabi::engine {

/// Statistics of one rank, or sums over ranks.
struct RankStatistics {
  std::uint64_t opened = 0;              ///< nodes opened here
  std::uint64_t fingerprint = 0;         ///< mark sum of these nodes, modulo 2^64
  std::uint64_t pruned = 0;              ///< nodes pruned by the incumbent
  std::uint64_t found = 0;               ///< solutions found here (that were the best when found)
  std::uint64_t peak_open = 0;           ///< maximum number of open nodes
  std::uint64_t requests = 0;            ///< requests for work sent
  std::uint64_t transfers_received = 0;  ///< work transfers received
  std::uint64_t transfers_sent = 0;      ///< work transfers sent
  std::uint64_t nodes_given = 0;         ///< nodes in these transfers
  /// Requests, transfers, refusals, incumbents; not the final report.
  std::uint64_t messages_sent = 0;
  double idle_seconds = 0;     ///< time without an open node, of which
  double ramp_up_seconds = 0;  ///< before the first node
  double tail_seconds = 0;     ///< after the last node
  double seconds = 0;          ///< duration of the search

  /// Sums. (Of the peaks too: ranks need not have reached theirs at one time.)
  RankStatistics& operator+=(const RankStatistics& other) {
    opened += other.opened;
    fingerprint += other.fingerprint;
    pruned += other.pruned;
    found += other.found;
    peak_open += other.peak_open;
    requests += other.requests;
    transfers_received += other.transfers_received;
    transfers_sent += other.transfers_sent;
    nodes_given += other.nodes_given;
    messages_sent += other.messages_sent;
    idle_seconds += other.idle_seconds;
    ramp_up_seconds += other.ramp_up_seconds;
    tail_seconds += other.tail_seconds;
    seconds += other.seconds;
    return *this;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& opened& fingerprint& pruned& found& peak_open& requests& transfers_received&
        transfers_sent;
    archive& nodes_given& messages_sent& idle_seconds& ramp_up_seconds& tail_seconds& seconds;
  }
};

/// Reason for the end of a search.
enum class Status {
  solved,      ///< the whole tree is searched
  time_limit,  ///< stopped at a limit of `Limits`; the solutions found are valid but not complete
  node_limit,
  solution_limit,
  gap_limit,
  interrupted,  ///< stopped by `Options::interrupt`
};

}  // namespace kusabi::engine
