// The limits of a call for work that is no search: how much of its time is left, and whether a
// signal asks for an end.
#pragma once

#include "nodes/linear/stop.hpp"

namespace kusabi::run {

/// The time begins to run when this is made.
class CallLimits {
 public:
  /// @param seconds infinity: no limit
  explicit CallLimits(double seconds);

  /// True when the time is over or a signal has asked for an end; it then stays so.
  [[nodiscard]] nodes::linear::Stop stop() const;
  [[nodiscard]] bool time_is_over() const;
  /// Above zero, so that a search which is given it can begin.
  [[nodiscard]] double seconds_left() const;

 private:
  double end_;  // of the steady clock, in seconds
};

}  // namespace kusabi::run
