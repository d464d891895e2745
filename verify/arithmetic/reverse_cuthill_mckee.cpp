// Reverse Cuthill-McKee order: breadth-first from an unknown with few neighbours.
#include "verify/arithmetic/reverse_cuthill_mckee.hpp"

#include <algorithm>
#include <numeric>

namespace kusabi::verify {

std::vector<std::size_t> reverse_cuthill_mckee(
    const std::vector<std::vector<std::size_t>>& neighbours) {
  const auto fewer = [&](std::size_t a, std::size_t b) {
    return neighbours[a].size() < neighbours[b].size();
  };
  std::vector<std::size_t> starts(neighbours.size());
  std::iota(starts.begin(), starts.end(), std::size_t{0});
  std::stable_sort(starts.begin(), starts.end(), fewer);
  std::vector<bool> taken(neighbours.size(), false);
  std::vector<std::size_t> order;
  const auto take = [&](std::size_t unknown) {
    taken[unknown] = true;
    order.push_back(unknown);
  };
  for (const auto start : starts) {
    if (taken[start]) continue;
    auto next = order.size();
    take(start);
    for (; next < order.size(); ++next) {
      auto around = neighbours[order[next]];
      std::stable_sort(around.begin(), around.end(), fewer);
      for (const auto unknown : around) {
        if (!taken[unknown]) take(unknown);
      }
    }
  }
  std::reverse(order.begin(), order.end());
  return order;
}

}  // namespace kusabi::verify
