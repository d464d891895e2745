// Budget: limits of time and nodes and stop requests of an analysis that runs several searches in
// sequence, with work between them.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

#include "engine/options.hpp"
#include "engine/outcome.hpp"

namespace kusabi::engine {

class Budget {
 public:
  /// Starts the clock.
  /// @param interrupt as Options::interrupt, for example asked_by_signal; empty: never interrupted.
  ///   A checkpoint request may be reported once, a stop request must be reported on every call.
  explicit Budget(const Limits& limits, std::function<Interrupt()> interrupt = {});

  /// Limits of the next search: the seconds and the nodes that remain.
  [[nodiscard]] Limits left() const;

  /// Counts opened nodes of all ranks together. @pre every rank counts the same
  void count(std::uint64_t nodes) { nodes_ += nodes; }

  /// True if the time is up, the nodes are used up or a stop was requested. The value is local to
  /// this rank.
  [[nodiscard]] bool spent() const;

  /// `spent` as a function, for long computations without a clock. This object must outlive it.
  [[nodiscard]] std::function<bool()> stop() const {
    return [this] { return spent(); };
  }

  /// Seconds since the clock was started.
  [[nodiscard]] double seconds() const;

  /// Reason for stopping. @pre spent()
  [[nodiscard]] Status stop_reason() const;

  /// Options::interrupt of the next search, which also delivers earlier requests. Empty if there is
  /// no source of requests. This object must outlive it.
  [[nodiscard]] std::function<Interrupt()> interrupt() const;

 private:
  [[nodiscard]] bool end_asked() const;

  Limits limits_;
  std::function<Interrupt()> interrupt_;
  std::uint64_t nodes_ = 0;                // opened so far
  mutable bool checkpoint_asked_ = false;  // requested, and not yet passed to a search
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace kusabi::engine
