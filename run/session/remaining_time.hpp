// RemainingTime: estimate of the remaining time of a search from the rate at which the closed share
// of its tree grows.
#pragma once

#include <optional>

namespace kusabi::run {

/// Shares of a tree predict work poorly: a large branch may be pruned at once, a tiny one may last
/// for hours. The rate is therefore exponentially smoothed over a quarter of the elapsed time (10 s
/// at least).
class RemainingTime {
 public:
  /// Records the closed share, 0 to 1, at a time since the start. The first call sets the origin:
  /// shares closed before a restart do not count towards the rate of this run.
  void observe(double seconds, double closed);

  /// Remaining seconds; nothing without enough data: one second, half a percent of the tree, and
  /// ten increases of the closed share.
  [[nodiscard]] std::optional<double> seconds() const;

 private:
  bool begun_ = false;
  double first_seconds_ = 0;
  double first_closed_ = 0;
  double last_seconds_ = 0;
  double last_closed_ = 0;
  double rate_ = 0;    // weighted sum of rates
  double weight_ = 0;  // sum of weights; tends to 1
  int advances_ = 0;
};

}  // namespace kusabi::run
