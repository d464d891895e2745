// Names of candidates.
#include "verify/structure/structure.hpp"

#include <algorithm>

namespace kusabi::verify {

std::map<std::size_t, std::vector<std::size_t>> shared_nodes(const Structure& structure) {
  std::map<std::size_t, std::vector<std::size_t>> at_node;
  for (std::size_t i = 0; i < structure.contact.size(); ++i)
    at_node[structure.contact[i].node].push_back(i);
  std::erase_if(at_node, [](const auto& each) { return each.second.size() == 1; });
  return at_node;
}

std::string name_of(const Structure& structure, std::size_t candidate) {
  const auto& point = structure.contact[candidate];
  auto name = structure.names[point.node];
  std::vector<std::string> surfaces;  // of the candidates at the node
  std::size_t before = 0;
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    if (structure.contact[i].node != point.node) continue;
    surfaces.push_back(structure.contact[i].surface);
    if (i < candidate) ++before;
  }
  if (surfaces.size() > 1) {
    std::sort(surfaces.begin(), surfaces.end());
    const bool named = !surfaces.front().empty() &&
                       std::adjacent_find(surfaces.begin(), surfaces.end()) == surfaces.end();
    name += "@" + (named ? point.surface : std::to_string(before + 1));
  }
  if (point.against.empty()) return name;
  auto nearest = point.against.front();
  for (const auto& part : point.against) {
    if (part.weight > nearest.weight) nearest = part;
  }
  name += "|" + structure.names[nearest.node];
  if (point.against.size() > 1) name += "+";
  return name;
}

}  // namespace kusabi::verify
