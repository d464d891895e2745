// Stop: a callback that ends long computations, which then need no clock or signal handler. The
// result of a completed computation must not depend on the calls.
#pragma once

#include <exception>
#include <functional>

namespace kusabi::support {

/// True: end soon with the result so far. Empty: never. It may be called often, and by each rank
/// separately; once true it should stay true.
using Stop = std::function<bool()>;

inline bool is_requested(const Stop& stop) {
  return stop && stop();
}

/// Exception that ends a computation whose partial result is of no use.
class Stopped : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "stopped before its end"; }
};

/// @throws Stopped if an end is requested
inline void throw_if_requested(const Stop& stop) {
  if (is_requested(stop)) throw Stopped();
}

/// Stop request and progress report of a computation in steps.
struct LongWork {
  Stop stop = {};
  /// Receives the name of the computation and its completed share, 0 to 1; may be empty.
  std::function<void(const char* work, double share)> on_share = {};

  /// @throws Stopped if an end is requested
  void report_share(const char* work, double share) const {
    throw_if_requested(stop);
    if (on_share) on_share(work, share);
  }
};

}  // namespace kusabi::support
