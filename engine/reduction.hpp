// Reduction: the data of one reduction wave, merged over all ranks (MPI_Iallreduce).
//
// Each rank contributes its own values from time to time. Termination, progress output and all
// other global decisions use the merged values only.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace kusabi::engine {

/// Requests of a rank to all ranks: bits, combined by or.
enum RequestFlag : std::uint64_t {
  request_stop_time = 1U << 0U,       ///< the time limit is reached
  request_stop_interrupt = 1U << 1U,  ///< the user or the batch system requests a stop
  request_checkpoint = 1U << 2U,      ///< a checkpoint is due
  report_write_failure = 1U << 3U,    ///< this rank could not write its part of the checkpoint
};

/// Sums over the merged ranks. The contribution of a rank describes its state at the moment at
/// which it joins the wave.
struct Reduction {
  std::uint64_t ranks = 0;  ///< number of merged ranks
  std::uint64_t idle = 0;   ///< ranks that open no nodes: they have none, or they pause
  std::uint64_t quiet = 0;  ///< ranks that are quiet (engine/detail/protocol/termination.hpp)
  /// ranks that received a counted message sent after its sender had joined this wave
  std::uint64_t crossed = 0;
  std::uint64_t sent = 0;           ///< counted messages sent: transfers, incumbents
  std::uint64_t received = 0;       ///< such messages received
  std::uint64_t opened = 0;         ///< nodes opened
  std::uint64_t open = 0;           ///< open nodes
  std::uint64_t found = 0;          ///< solutions found
  std::uint64_t fingerprint = 0;    ///< mark sum of the opened nodes
  std::uint64_t request_flags = 0;  ///< bits of `RequestFlag`
  double closed = 0;                ///< closed share of the tree, 0 to 1
  double objective = std::numeric_limits<double>::infinity();  ///< of the incumbent: minimum
  double bound = std::numeric_limits<double>::infinity();      ///< of the open nodes: minimum

  /// Merges another reduction. Commutative and associative, except for the rounding of `closed`,
  /// which is used for display only.
  void merge(const Reduction& other) {
    ranks += other.ranks;
    idle += other.idle;
    quiet += other.quiet;
    crossed += other.crossed;
    sent += other.sent;
    received += other.received;
    opened += other.opened;
    open += other.open;
    found += other.found;
    fingerprint += other.fingerprint;
    request_flags |= other.request_flags;
    closed += other.closed;
    objective = std::min(objective, other.objective);
    bound = std::min(bound, other.bound);
  }
};

static_assert(std::is_trivially_copyable_v<Reduction>, "a reduction is sent as raw bytes");

}  // namespace kusabi::engine
