// Bodies by disjoint sets; coincident nodes by a grid of cells.
#include "problems/structure/bodies/connected_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include <boost/pending/disjoint_sets.hpp>
#include <fmt/format.h>

#include "problems/structure/model/superelement.hpp"

namespace kusabi::problems {
namespace {

/// Number of the farthest cell: integers of 64 bits have no larger ones.
constexpr double farthest_cell = 1e18;

/// Nodes closer than this, relative to the extent of the structure, coincide. The tolerance is far
/// above the differences that mesh generators leave between coincident nodes and far below the size
/// of elements.
constexpr double one_place = 1e-7;
/// The same relative to the shortest bar or edge, which may be far shorter than other members.
constexpr double one_place_of_edges = 1e-3;

/// Cells of the size of the tolerance.
class Cells {
 public:
  explicit Cells(const Structure& structure) : structure_(structure) {
    const auto& places = structure.coordinates;
    minimum_ = places.rowwise().minCoeff();
    size_ = one_place * (places.rowwise().maxCoeff() - minimum_).maxCoeff();
    for (const Member& member : structure.members) limit_by(member.first, member.second);
    for (const Element& element : structure.elements) {
      for (std::size_t i = 1; i < element.nodes.size(); ++i)
        limit_by(element.nodes[i - 1], element.nodes[i]);
    }
  }
  [[nodiscard]] double size() const { return size_; }

  /// Adds a node. @return a node added before at the same place, if any
  std::optional<int> add(int node) {
    const Cell own = cell(node);
    std::optional<int> found;
    Cell near{};
    const std::int64_t across = structure_.dimension == 3 ? 1 : 0;
    for (near[0] = own[0] - 1; near[0] <= own[0] + 1; ++near[0]) {
      for (near[1] = own[1] - 1; near[1] <= own[1] + 1; ++near[1]) {
        for (near[2] = own[2] - across; near[2] <= own[2] + across; ++near[2]) {
          const auto [first, last] = nodes_.equal_range(near);
          for (auto each = first; each != last && !found; ++each) {
            if (distance(each->second, node) <= size_) found = each->second;
          }
        }
      }
    }
    nodes_.emplace(own, node);
    return found;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  void limit_by(int first, int second) {
    const double edge = distance(first, second);
    if (edge > 0) size_ = std::min(size_, one_place_of_edges * edge);
  }

  [[nodiscard]] Cell cell(int node) const {
    Cell cell{};
    for (Eigen::Index axis = 0; axis < structure_.dimension; ++axis) {
      const double place = (structure_.coordinates(axis, node) - minimum_(axis)) / size_;
      cell[static_cast<std::size_t>(axis)] =
          static_cast<std::int64_t>(std::floor(std::min(place, farthest_cell)));
    }
    return cell;
  }
  [[nodiscard]] double distance(int first, int second) const {
    return (structure_.coordinates.col(first) - structure_.coordinates.col(second)).norm();
  }

  const Structure& structure_;
  Eigen::VectorXd minimum_;
  double size_ = 0;
  std::multimap<Cell, int> nodes_;
};

/// Nodes that may coincide with others: supported ones, those in contact with another body, and
/// tied ones.
std::set<int> meant_apart(const Structure& structure) {
  std::set<int> nodes;
  for (const auto& candidate : structure.contact) {
    if (candidate.against.empty()) continue;
    nodes.insert(candidate.node);
    for (const auto& share : candidate.against) nodes.insert(share.node);
  }
  for (int node = 0; node < std::ssize(structure.node_names); ++node) {
    if (is_ground(structure, node)) nodes.insert(node);
  }
  for (const auto& tie : structure.ties) nodes.insert(tie.node);
  return nodes;
}

}  // namespace

bool is_ground(const Structure& structure, int node) {
  const auto& fixed = structure.fixed[static_cast<std::size_t>(node)];
  return std::all_of(fixed.begin(), fixed.begin() + structure.dimension,
                     [](bool axis) { return axis; });
}

std::vector<std::set<int>> connected_bodies(const Structure& structure) {
  boost::disjoint_sets_with_storage<> sets(structure.node_names.size());
  std::vector<std::vector<int>> links;
  for (const Member& member : structure.members) links.push_back({member.first, member.second});
  for (const Element& element : structure.elements) links.push_back(element.nodes);
  for (const Superelement& each : structure.superelements) links.push_back(nodes_of(each));
  for (const MultiPointConstraint& tie : structure.ties) {
    links.push_back({tie.node});
    for (const WeightedNode& share : tie.to) {  // ground nodes support the node, not the body
      if (!is_ground(structure, share.node)) links.back().push_back(share.node);
    }
  }
  const auto first_free = [&](const std::vector<int>& nodes) {
    return std::ranges::find_if(nodes, [&](int node) { return !is_ground(structure, node); });
  };
  for (const auto& nodes : links) {
    const auto first = first_free(nodes);
    for (const int node : nodes) {
      if (first == nodes.end() || is_ground(structure, node)) continue;
      sets.union_set(static_cast<std::size_t>(*first), static_cast<std::size_t>(node));
    }
  }
  std::map<std::size_t, std::set<int>> by_set;
  std::map<int, std::size_t> order;  // first node -> set
  for (const auto& nodes : links) {
    const auto first = first_free(nodes);
    if (first == nodes.end()) continue;
    by_set[sets.find_set(static_cast<std::size_t>(*first))].insert(nodes.begin(), nodes.end());
  }
  for (const auto& [set, nodes] : by_set) {
    order.emplace(*std::ranges::find_if(nodes, [&](int n) { return !is_ground(structure, n); }),
                  set);
  }
  std::vector<std::set<int>> result;
  result.reserve(order.size());
  for (const auto& [node, set] : order) result.push_back(std::move(by_set[set]));
  return result;
}

std::vector<std::string> coincidence_warnings(const Structure& structure) {
  Cells cells(structure);
  if (!(cells.size() > 0)) return {};
  const auto bodies = connected_bodies(structure);
  const auto apart = meant_apart(structure);
  std::vector<std::pair<int, int>> pairs;
  for (const auto& body : bodies) {
    for (const int node : body) {
      if (apart.contains(node)) continue;
      if (const auto other = cells.add(node)) pairs.emplace_back(*other, node);
    }
  }
  if (pairs.empty()) return {};
  const auto [first, second] = pairs.front();
  const auto message = fmt::format(
      "{} {} at the place of another node without connection, such as {} and {}, so that each "
      "moves independently{}; expected one node at a place (in Gmsh: Coherence, Coherence Mesh), "
      "[[ties]] "
      "between them, or a [[contact]] with against where bodies touch",
      pairs.size(), pairs.size() == 1 ? "node is" : "nodes are", quoted_name(structure, first),
      quoted_name(structure, second),
      bodies.size() > 1 ? fmt::format(" (the structure is of {} bodies)", bodies.size()) : "");
  return {structure_error(structure, position_of(structure.sources.nodes, second), message).what()};
}

}  // namespace kusabi::problems
