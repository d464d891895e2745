// Collective operations, each by one reduction wave.
#include "engine/collectives.hpp"

#include <chrono>
#include <string>
#include <thread>

namespace kusabi::engine {

Reduction all_reduce(Transport& transport, const Reduction& own) {
  transport.join_reduction(own);
  for (;;) {
    if (const auto all = transport.reduction()) return *all;
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

void require_equal_on_all_ranks(Transport& transport, std::uint64_t fingerprint) {
  const auto first = from_first_rank(transport, [&] { return fingerprint; });
  // The reduction counts the ranks with another fingerprint.
  const auto all = all_reduce(transport, {.ranks = 1, .found = first == fingerprint ? 0U : 1U});
  if (all.found == 0) return;
  throw RankMismatch(
      std::to_string(all.found) + " of " + std::to_string(all.ranks) +
      " ranks computed a problem from the same file that differs from that of rank 0; expected "
      "machines of one kind and the same build of kusabi on each");
}

}  // namespace kusabi::engine
