// Budget: remaining time, and stop or checkpoint requests that arrive between searches.
#include "engine/analysis/budget.hpp"

#include <algorithm>
#include <utility>

namespace kusabi::engine {

Budget::Budget(const Limits& limits, std::function<Interrupt()> interrupt)
    : limits_(limits), interrupt_(std::move(interrupt)) {}

double Budget::seconds() const {
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
  return spent.count();
}

Limits Budget::left() const {
  Limits limits = limits_;
  limits.seconds = std::max(0.0, limits.seconds - seconds());
  if (limits.nodes != Limits{}.nodes) limits.nodes -= std::min(limits.nodes, nodes_);
  return limits;
}

bool Budget::end_asked() const {
  if (!interrupt_) return false;
  const auto asked = interrupt_();
  checkpoint_asked_ = checkpoint_asked_ || asked == Interrupt::checkpoint;
  return asked == Interrupt::stop;
}

bool Budget::spent() const {
  return end_asked() || seconds() >= limits_.seconds || nodes_ >= limits_.nodes;
}

Status Budget::stop_reason() const {
  if (end_asked()) return Status::interrupted;
  return nodes_ >= limits_.nodes ? Status::node_limit : Status::time_limit;
}

std::function<Interrupt()> Budget::interrupt() const {
  if (!interrupt_) return {};
  return [this] {
    if (end_asked()) return Interrupt::stop;
    return std::exchange(checkpoint_asked_, false) ? Interrupt::checkpoint : Interrupt::none;
  };
}

}  // namespace kusabi::engine
