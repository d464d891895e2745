// A survey is what all ranks can bring together; so a meeting is one wave of it.
#include "engine/together.hpp"

#include <chrono>
#include <string>
#include <thread>

namespace kusabi::engine {

Survey meet(Transport& transport, const Survey& own) {
  transport.join_survey(own);
  for (;;) {
    if (const auto all = transport.survey()) return *all;
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

void agree(Transport& transport, std::uint64_t fingerprint) {
  const auto first = from_first_rank(transport, [&] { return fingerprint; });
  // A survey counts, and here it counts the ranks that have something else.
  const auto all = meet(transport, {.ranks = 1, .found = first == fingerprint ? 0U : 1U});
  if (all.found == 0) return;
  throw Disagreement(
      std::to_string(all.found) + " of " + std::to_string(all.ranks) +
      " ranks have worked out another problem from the same file than rank 0: expected machines of "
      "one kind and the same build of kusabi on each");
}

}  // namespace kusabi::engine
