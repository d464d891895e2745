// Random victims and exponential back-off.
#include "engine/detail/protocol/victims.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "engine/detail/contract.hpp"
#include "engine/path.hpp"

namespace kusabi::engine {
namespace {

// After three refusals a rank registers with its lifelines and pauses for them; so the first pauses
// are short compared with a round trip, and the last one is never reached.
constexpr double shortest_pause = 1e-6;
constexpr double longest_pause = 10e-3;

constexpr int max_neighbours = 32;

// The bias of the remainder is below 2^-40 for any realistic number.
std::uint64_t draw(std::uint64_t& random, std::uint64_t below) {
  random = branch_hash(random, 0);
  return random % below;
}

std::vector<int> neighbours_of(int self, int ranks, std::uint64_t seed) {
  const auto others = static_cast<std::uint64_t>(ranks) - 1;
  const auto count = std::min<std::uint64_t>(max_neighbours, others);
  std::set<int> neighbours;
  while (neighbours.size() < count) {
    const auto distance = 1 + static_cast<long>(draw(seed, others));
    neighbours.insert(static_cast<int>((self + distance) % ranks));
    neighbours.insert(static_cast<int>((self + ranks - distance) % ranks));
  }
  return {neighbours.begin(), neighbours.end()};
}

}  // namespace

Victims::Victims(int self, int ranks, std::uint64_t seed, std::vector<int> machine)
    : random_(branch_hash(seed, static_cast<std::uint32_t>(self))),
      machine_(std::move(machine)),
      max_refusals_(ranks <= few_ranks ? 0 : max_refusals),
      pause_(shortest_pause) {
  ensure(ranks >= 2, "a rank chooses a victim only among several ranks");
  neighbours_ = neighbours_of(self, ranks, seed);
}

int Victims::choose() {
  if (last_sender_ >= 0) return last_sender_;
  const auto& candidates = drawn_refused_ || machine_.empty() ? neighbours_ : machine_;
  return candidates[draw(random_, candidates.size())];
}

void Victims::sent(int victim) {
  last_sender_ = victim;
  pause_ = shortest_pause;
  next_request_ = 0;
  refusals_ = 0;
  drawn_refused_ = false;
}

void Victims::refused(int victim, double now) {
  if (last_sender_ == victim) {
    last_sender_ = -1;
  } else {
    drawn_refused_ = true;
  }
  ++refusals_;
  next_request_ = now + pause_;
  pause_ = std::min(2 * pause_, longest_pause);
}

}  // namespace kusabi::engine
