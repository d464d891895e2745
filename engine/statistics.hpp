// What a search says of itself, whatever it searched.
#pragma once

#include <cstdint>

namespace kusabi::engine {

/// What one rank did.
struct RankStatistics {
  std::uint64_t opened = 0;          ///< nodes opened here
  std::uint64_t fingerprint = 0;     ///< sum of the marks of their paths, modulo 2^64
  std::uint64_t pruned = 0;          ///< nodes not opened: they could not beat the best solution
  std::uint64_t found = 0;           ///< solutions found here (that were the best at their time)
  std::uint64_t peak_open = 0;       ///< most nodes that were waiting at one time
  std::uint64_t requests = 0;        ///< times it asked for work
  std::uint64_t gifts_received = 0;  ///< times it was given some
  std::uint64_t gifts_sent = 0;      ///< times it gave some
  std::uint64_t nodes_given = 0;     ///< nodes in those
  std::uint64_t messages_sent = 0;   ///< requests, gifts, refusals, news; not the report at the end
  double idle_seconds = 0;           ///< time without an open node, of which
  double ramp_up_seconds = 0;        ///< before the first node
  double tail_seconds = 0;           ///< after the last
  double seconds = 0;                ///< time from the start to the end of the search

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& opened& fingerprint& pruned& found& peak_open& requests& gifts_received& gifts_sent;
    archive& nodes_given& messages_sent& idle_seconds& ramp_up_seconds& tail_seconds& seconds;
  }
};

/// Why a search ended.
enum class Status {
  solved,      ///< the whole tree is done
  time_limit,  ///< stopped at a limit of `Limits`; what was found is valid, not complete
  node_limit,
  solution_limit,
  gap_limit,
  interrupted,  ///< stopped because `Options::interrupt` said so
};

}  // namespace kusabi::engine
