// The limits of a command that does several things, one after another, and a signal that ends it.
#pragma once

#include <chrono>

#include "engine/options.hpp"
#include "engine/outcome.hpp"
#include "support/stop.hpp"

namespace kusabi::run {

class Budget {
 public:
  /// The clock starts here, and signals are heeded from here on.
  explicit Budget(const engine::Limits& limits);

  /// For the next search: with the seconds that are left.
  [[nodiscard]] engine::Limits left() const;

  /// Whether the time is up, or a signal has asked for an end: of this rank alone.
  [[nodiscard]] bool spent() const;

  /// `spent`, for work that knows nothing of clocks and signals. This must outlive it.
  [[nodiscard]] support::Stop stop() const {
    return [this] { return spent(); };
  }

  /// Why, after `spent`.
  [[nodiscard]] engine::Status why() const;

 private:
  [[nodiscard]] double seconds() const;

  engine::Limits limits_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace kusabi::run
