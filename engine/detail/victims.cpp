// Random victims and exponential back-off.
#include "engine/detail/victims.hpp"

#include <algorithm>

#include "engine/detail/contract.hpp"
#include "engine/path.hpp"

namespace kusabi::engine {
namespace {

// After three refusals a rank registers with its lifelines and pauses for them; so the first pauses
// are short compared with a round trip, and the last one is never reached.
constexpr double shortest_pause = 1e-6;
constexpr double longest_pause = 10e-3;

}  // namespace

Victims::Victims(int self, int ranks, std::uint64_t seed)
    : self_(self),
      ranks_(ranks),
      random_(branch_hash(seed, static_cast<std::uint32_t>(self))),
      patience_(ranks <= few_ranks ? 0 : longest_patience),
      pause_(shortest_pause) {
  ensure(ranks >= 2, "a rank chooses a victim only among several ranks");
}

int Victims::choose() {
  if (favourite_ >= 0) return favourite_;
  random_ = branch_hash(random_, 0);
  // The bias of the remainder is below 2^-40 for any realistic number of ranks.
  const auto others = static_cast<std::uint64_t>(ranks_) - 1;
  const int pick = static_cast<int>(random_ % others);
  return pick < self_ ? pick : pick + 1;
}

void Victims::gave(int victim) {
  favourite_ = victim;
  pause_ = shortest_pause;
  next_request_ = 0;
  refusals_ = 0;
}

void Victims::refused(int victim, double now) {
  if (favourite_ == victim) favourite_ = -1;
  ++refusals_;
  next_request_ = now + pause_;
  pause_ = std::min(2 * pause_, longest_pause);
}

}  // namespace kusabi::engine
