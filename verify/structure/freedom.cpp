// Numbering of the free displacements, then the weights of the dependent ones.
#include "verify/structure/freedom.hpp"

#include <cmath>

namespace kusabi::verify {
std::size_t largest_component_axis(const Vector& direction) {
  std::size_t axis = 0;
  for (std::size_t other = 1; other < direction.size(); ++other) {
    if (std::abs(direction[other]) > std::abs(direction[axis])) axis = other;
  }
  return axis;
}

Freedom::Freedom(const Structure& structure) {
  const auto d = structure.dimension;
  auto without = structure.fixed;
  for (const auto& tie : structure.ties) without[tie.node] = {true, true, true};
  for (const auto& each : structure.inclined)
    without[each.node][largest_component_axis(each.direction)] = true;
  for (const auto& axes : without) {
    auto& numbers = number.emplace_back();
    numbers.fill(none);
    for (std::size_t axis = 0; axis < d; ++axis) {
      if (!axes[axis]) numbers[axis] = count++;
    }
  }
  for (const auto& stiffness : structure.given) {
    auto& numbers = internal.emplace_back();
    for (const auto& row : stiffness.rows) numbers.push_back(row.node ? none : count++);
  }
  for (const auto& [node, direction] : structure.inclined) {
    const auto solved = largest_component_axis(direction);
    for (std::size_t axis = 0; axis < d; ++axis) {
      if (axis == solved || direction[axis] == 0) continue;
      masters[{node, solved}].emplace_back(
          number[node][axis], -(Enclosure(direction[axis]) / Enclosure(direction[solved])));
    }
  }
  const auto set_dependent = [&](std::size_t node, std::size_t axis,
                                 const std::vector<Part>& place) {
    std::vector<std::pair<std::size_t, Enclosure>> sum;
    for (const auto& [master, weight] : place) {
      if (number[master][axis] != none) sum.emplace_back(number[master][axis], Enclosure(weight));
      const auto indirect = masters.find({master, axis});
      if (indirect == masters.end()) continue;
      for (const auto& [at, share] : indirect->second)
        sum.emplace_back(at, Enclosure(weight) * share);
    }
    if (!sum.empty()) masters[{node, axis}] = std::move(sum);
  };
  const auto shared = shared_nodes(structure);
  for (std::size_t axis = 0; axis < d; ++axis) {
    for (const auto& tie : structure.ties) set_dependent(tie.node, axis, tie.to);
    // A candidate supported together with its opposite place has no displacement relative to it
    // (problems/structure/checks/constraint_check.hpp).
    for (const auto& point : structure.contact) {
      if (!structure.fixed[point.node][axis] && !shared.contains(point.node))
        set_dependent(point.node, axis, point.against);
    }
  }
}

std::vector<std::size_t> Freedom::parts(std::size_t node, std::size_t axis) const {
  std::vector<std::size_t> all;
  if (number[node][axis] != none) all.push_back(number[node][axis]);
  const auto found = masters.find({node, axis});
  if (found == masters.end()) return all;
  for (const auto& [at, weight] : found->second) all.push_back(at);
  return all;
}

std::vector<std::pair<std::size_t, Enclosure>> Freedom::weighted(std::size_t node,
                                                                 std::size_t axis) const {
  std::vector<std::pair<std::size_t, Enclosure>> all;
  if (number[node][axis] != none) all.emplace_back(number[node][axis], Enclosure(1));
  const auto found = masters.find({node, axis});
  if (found != masters.end()) all.insert(all.end(), found->second.begin(), found->second.end());
  return all;
}

void Freedom::add(std::pair<std::size_t, std::size_t> row,
                  std::pair<std::size_t, std::size_t> column, const Enclosure& value,
                  SparseEnclosure& matrix) const {
  const auto along_row = [&](std::size_t at, const Enclosure& part) {
    const auto beside = number[column.first][column.second];
    if (beside != none) matrix[at][beside] += part;
    if (masters.empty()) return;
    const auto found = masters.find(column);
    if (found == masters.end()) return;
    for (const auto& [to, weight] : found->second) matrix[at][to] += part * weight;
  };
  const auto at_row = number[row.first][row.second];
  if (at_row != none) along_row(at_row, value);
  if (masters.empty()) return;
  const auto found = masters.find(row);
  if (found == masters.end()) return;
  for (const auto& [at, weight] : found->second) along_row(at, value * weight);
}

}  // namespace kusabi::verify
