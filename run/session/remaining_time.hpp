// How much longer a search will take, guessed from how fast the closed share of its tree grows.
#pragma once

#include <optional>

namespace kusabi::run {

/// Shares of a tree say little about work: a large branch may be pruned at once, and a tiny one
/// last for hours. So the rate is that of the recent past, exponentially smoothed; the past reaches
/// back over a quarter of the run (10 s at least), since a longer run changes its ways more slowly.
class RemainingTime {
 public:
  /// Takes note of the closed share, 0 to 1, at a time since the start. The first call sets the
  /// beginning: what was closed then (before a restart) was not closed at this run's speed.
  void observe(double seconds, double closed);

  /// Seconds still to go; nothing as long as too little has been seen for a guess: less than a
  /// second, half a percent of the tree, or ten times at which something had been closed.
  [[nodiscard]] std::optional<double> seconds() const;

 private:
  bool begun_ = false;
  double first_seconds_ = 0;
  double first_closed_ = 0;
  double last_seconds_ = 0;
  double last_closed_ = 0;
  double rate_ = 0;    // smoothed, of the weights so far
  double weight_ = 0;  // their sum; 1 in the end
  int advances_ = 0;
};

}  // namespace kusabi::run
