// The content of one survey wave: what each rank says of itself, added up over all ranks.
//
// From time to time every rank hands in its own survey, and a reduction adds them up for all of
// them. The end of the search, the progress that a person sees, and whatever else concerns all
// ranks at once are read from the merged survey, and from nothing else.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace kusabi::engine {

/// What a rank wants all ranks to do; bits that are or-ed over the ranks.
enum Wish : std::uint64_t {
  wish_stop_time = 1U << 0U,       ///< the time is up
  wish_stop_interrupt = 1U << 1U,  ///< the user or the batch system asks for an end
  wish_checkpoint = 1U << 2U,      ///< it is time for a checkpoint
  wish_failed = 1U << 3U,          ///< this rank could not write its part of the checkpoint
};

/// Sums over the ranks that have been merged into it. A rank's own survey describes that rank at
/// the moment at which it joined the wave.
struct Survey {
  std::uint64_t ranks = 0;        ///< how many ranks are in it
  std::uint64_t idle = 0;         ///< ranks that open no nodes: they have none, or they pause
  std::uint64_t sent = 0;         ///< messages sent that may make their receiver act (gifts, news)
  std::uint64_t received = 0;     ///< such messages received
  std::uint64_t opened = 0;       ///< nodes opened
  std::uint64_t open = 0;         ///< nodes waiting to be opened
  std::uint64_t found = 0;        ///< solutions found
  std::uint64_t fingerprint = 0;  ///< sum of the path hashes of the opened nodes
  std::uint64_t wishes = 0;       ///< bits of `Wish`
  double closed = 0;              ///< share of the tree below which nothing is left to do, 0 to 1
  double objective = std::numeric_limits<double>::infinity();  ///< of the best solution: minimum
  double bound = std::numeric_limits<double>::infinity();      ///< of the open nodes: minimum

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
    fingerprint += other.fingerprint;
    wishes |= other.wishes;
    closed += other.closed;
    objective = std::min(objective, other.objective);
    bound = std::min(bound, other.bound);
  }
};

static_assert(std::is_trivially_copyable_v<Survey>, "a survey travels as raw bytes");

}  // namespace kusabi::engine
