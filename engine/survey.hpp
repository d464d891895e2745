// What all ranks know together: the content of one survey wave.
//
// From time to time every rank hands in its own survey, and a reduction adds them up for all of
// them. The end of the search, the progress that a person sees, and whatever else concerns all
// ranks at once are read from the merged survey, and from nothing else.
#pragma once

#include <cstdint>
#include <type_traits>

namespace kusabi::engine {

/// Sums over the ranks that have been merged into it. A rank's own survey describes that rank at
/// the moment at which it joined the wave.
struct Survey {
  std::uint64_t ranks = 0;     ///< how many ranks are in it
  std::uint64_t idle = 0;      ///< ranks without an open node
  std::uint64_t sent = 0;      ///< gifts sent since the search began
  std::uint64_t received = 0;  ///< gifts received since the search began
  std::uint64_t opened = 0;    ///< nodes opened
  std::uint64_t open = 0;      ///< nodes waiting to be opened
  std::uint64_t found = 0;     ///< solutions found
  double closed = 0;           ///< share of the tree below which nothing is left to do, 0 to 1

  /// Adds another survey. Commutative and associative (but for the rounding of `closed`, which is
  /// shown to people and decides nothing).
  void merge(const Survey& other) {
    ranks += other.ranks;
    idle += other.idle;
    sent += other.sent;
    received += other.received;
    opened += other.opened;
    open += other.open;
    found += other.found;
    closed += other.closed;
  }
};

static_assert(std::is_trivially_copyable_v<Survey>, "a survey travels as raw bytes");

}  // namespace kusabi::engine
