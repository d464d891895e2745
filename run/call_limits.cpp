// The clock, and the note of a signal.
#include "run/call_limits.hpp"

#include <algorithm>
#include <chrono>

#include "run/signals.hpp"

namespace kusabi::run {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

CallLimits::CallLimits(double seconds) : end_(now() + seconds) {}

nodes::linear::Stop CallLimits::stop() const {
  return [end = end_] { return end_asked_by_signal() || now() >= end; };
}

bool CallLimits::time_is_over() const {
  return now() >= end_;
}

double CallLimits::seconds_left() const {
  constexpr double least = 1e-3;
  return std::max(least, end_ - now());
}

}  // namespace kusabi::run
