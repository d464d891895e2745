// One clock and one note of signals.
#include "run/session/budget.hpp"

#include <algorithm>

#include "engine/signals.hpp"

namespace kusabi::run {

Budget::Budget(const engine::Limits& limits) : limits_(limits) {
  engine::heed_signals();
}

double Budget::seconds() const {
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
  return spent.count();
}

engine::Limits Budget::left() const {
  engine::Limits limits = limits_;
  limits.seconds = std::max(0.0, limits.seconds - seconds());
  return limits;
}

bool Budget::spent() const {
  return engine::end_asked_by_signal() || seconds() >= limits_.seconds;
}

engine::Status Budget::why() const {
  return engine::end_asked_by_signal() ? engine::Status::interrupted : engine::Status::time_limit;
}

}  // namespace kusabi::run
