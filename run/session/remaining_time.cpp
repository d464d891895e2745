// Exponential smoothing over unequal intervals, with correction of the initial bias.
#include "run/session/remaining_time.hpp"

#include <algorithm>
#include <cmath>

namespace kusabi::run {
namespace {

constexpr double shortest_memory = 10;  // seconds
constexpr double memory_share = 0.25;   // of the elapsed time
constexpr double least_seconds = 1;
constexpr double min_closed = 0.005;
constexpr int min_advances = 10;

}  // namespace

void RemainingTime::observe(double seconds, double closed) {
  if (!begun_) {
    begun_ = true;
    first_seconds_ = last_seconds_ = seconds;
    first_closed_ = last_closed_ = closed;
    return;
  }
  const double elapsed = seconds - last_seconds_;
  if (!(elapsed > 0)) return;
  const double advance = std::max(0.0, closed - last_closed_);
  const double memory = std::max(shortest_memory, memory_share * (seconds - first_seconds_));
  const double fresh = -std::expm1(-elapsed / memory);
  rate_ += fresh * (advance / elapsed - rate_);
  weight_ += fresh * (1 - weight_);
  if (advance > 0) ++advances_;
  last_seconds_ = seconds;
  last_closed_ = std::max(last_closed_, closed);
}

std::optional<double> RemainingTime::seconds() const {
  if (last_seconds_ - first_seconds_ < least_seconds) return std::nullopt;
  if (last_closed_ - first_closed_ < min_closed || advances_ < min_advances) {
    return std::nullopt;
  }
  return std::max(0.0, 1 - last_closed_) * weight_ / rate_;
}

}  // namespace kusabi::run
