// Broadcast tree of the incumbent, with a fan-out of 16: an improvement reaches 65,536 ranks in at
// most eight hops, and no rank sends more than 17 messages.
#pragma once

#include <algorithm>
#include <vector>

namespace kusabi::engine {

inline constexpr int relay_fan_out = 16;

/// The parent of a rank other than 0 in the tree rooted at rank 0.
inline int relay_parent(int rank) {
  return (rank - 1) / relay_fan_out;
}

/// The parent and the children of a rank in the tree rooted at rank 0.
inline std::vector<int> relay_neighbours(int rank, int ranks) {
  std::vector<int> neighbours;
  if (rank > 0) neighbours.push_back(relay_parent(rank));
  const long first = static_cast<long>(relay_fan_out) * rank + 1;
  for (long child = first; child < std::min<long>(first + relay_fan_out, ranks); ++child) {
    neighbours.push_back(static_cast<int>(child));
  }
  return neighbours;
}

}  // namespace kusabi::engine
