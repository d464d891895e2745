// What a caller can choose about a search, and what it can watch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace kusabi::engine {

/// The state of a running search, as of the last survey.
struct Progress {
  double seconds = 0;        ///< since the search began
  std::uint64_t opened = 0;  ///< nodes opened, on all ranks
  std::uint64_t open = 0;    ///< nodes waiting
  std::uint64_t found = 0;   ///< solutions
  double closed = 0;         ///< share of the tree that is done, 0 to 1
  std::uint64_t idle = 0;    ///< ranks without work
};

struct Options {
  /// Seconds between two surveys while all ranks are busy (idle ranks join at once).
  double survey_interval = 0.05;

  /// Seed of the random choice of victims. The outcome does not depend on it.
  std::uint64_t seed = 1;

  /// Nodes opened between two looks at the messages; 0: as many as take 10 to 20 microseconds.
  unsigned nodes_per_step = 0;

  /// Upper limit, in bytes, that the engine aims at for one message.
  std::size_t message_bytes = std::size_t{64} * 1024;

  /// Called on rank 0 after each survey.
  std::function<void(const Progress&)> progress;
};

}  // namespace kusabi::engine
