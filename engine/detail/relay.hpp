// Broadcast tree of the incumbent, with a fan-out of 16: an improvement reaches 65,536 ranks in at
// most eight hops, and no rank sends more than 17 messages.
#pragma once

#include <algorithm>
#include <vector>

namespace kusabi::engine {

/// The parent and the children of a rank in the tree rooted at rank 0.
inline std::vector<int> relay_neighbours(int rank, int ranks) {
  constexpr int fan_out = 16;
  std::vector<int> neighbours;
  if (rank > 0) neighbours.push_back((rank - 1) / fan_out);
  const long first = static_cast<long>(fan_out) * rank + 1;
  for (long child = first; child < std::min<long>(first + fan_out, ranks); ++child) {
    neighbours.push_back(static_cast<int>(child));
  }
  return neighbours;
}

}  // namespace kusabi::engine
