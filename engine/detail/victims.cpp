// Random victims and exponential back-off.
#include "engine/detail/victims.hpp"

#include <algorithm>

#include "engine/detail/contract.hpp"
#include "engine/path.hpp"

namespace kusabi::engine {
namespace {

// The first pause is about one round trip over shared memory. The last one is not noticeable to a
// user and long compared with the cost of an answer. (A rank that waits so long is registered with
// its lifelines, which bring work sooner.)
constexpr double shortest_pause = 10e-6;
constexpr double longest_pause = 10e-3;

}  // namespace

Victims::Victims(int self, int ranks, std::uint64_t seed)
    : self_(self),
      ranks_(ranks),
      random_(branch_hash(seed, static_cast<std::uint32_t>(self))),
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
