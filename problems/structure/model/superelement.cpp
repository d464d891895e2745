// Nodes connected by a superelement.
#include "problems/structure/model/superelement.hpp"

#include <algorithm>

namespace kusabi::problems {

std::vector<int> nodes_of(const Superelement& superelement) {
  std::vector<int> nodes;
  for (const SuperelementRow& row : superelement.rows) {
    if (row.node >= 0) nodes.push_back(row.node);
  }
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace kusabi::problems
