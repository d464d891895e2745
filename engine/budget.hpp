// The limits of time and nodes and the signals of a question that takes several searches, one after
// another with work between them.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

#include "engine/options.hpp"
#include "engine/outcome.hpp"

namespace kusabi::engine {

class Budget {
 public:
  /// The clock starts here.
  /// @param interrupt as Options::interrupt, say asked_by_signal; empty: nobody asks. That a
  ///   checkpoint is wanted it may tell once; that an end is, as often as it is asked.
  explicit Budget(const Limits& limits, std::function<Interrupt()> interrupt = {});

  /// For the next search: with the seconds and the nodes that are left.
  [[nodiscard]] Limits left() const;

  /// Counts nodes that were opened, on all ranks together; every rank counts the same.
  void count(std::uint64_t nodes) { nodes_ += nodes; }

  /// Whether the time is up, the nodes are opened, or an end has been asked for: of this rank
  /// alone.
  [[nodiscard]] bool spent() const;

  /// `spent`, for work that knows nothing of clocks and signals. This must outlive it.
  [[nodiscard]] std::function<bool()> stop() const {
    return [this] { return spent(); };
  }

  /// Since the clock was started.
  [[nodiscard]] double seconds() const;

  /// Why, after `spent`.
  [[nodiscard]] Status why() const;

  /// Options::interrupt of the next search: what was asked for before it is not lost. This must
  /// outlive it; empty if nobody asks.
  [[nodiscard]] std::function<Interrupt()> interrupt() const;

 private:
  [[nodiscard]] bool end_asked() const;

  Limits limits_;
  std::function<Interrupt()> interrupt_;
  std::uint64_t nodes_ = 0;                // opened so far
  mutable bool checkpoint_asked_ = false;  // and no search has been told
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace kusabi::engine
