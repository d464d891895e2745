// Sums of products of doubles in rational numbers; 320 binary digits represent them exactly.
#include "verify/structure/placed_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace kusabi::verify {
namespace {

// Bound of the rounding errors of a sum of products of coordinates and weights, relative to the
// largest.
constexpr double rounded_place = 0x1p-48;

// The place opposite to a candidate if its node differs from it by rounding only.
std::optional<Rationals> place_of(const Structure& structure, const ContactPoint& point) {
  Rationals place(structure.dimension);
  double largest = 0;
  double off = 0;
  for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
    for (const auto& [node, weight] : point.against) {
      const double coordinate = structure.coordinates[node][axis];
      place[axis] += mpq_class(weight) * mpq_class(coordinate);
      largest = std::max(largest, std::abs(coordinate));
    }
    const double own = structure.coordinates[point.node][axis];
    largest = std::max(largest, std::abs(own));
    const mpq_class away = place[axis] - mpq_class(own);
    off = std::max(off, std::abs(away.get_d()));
  }
  if (point.against.empty() || off == 0 || off > rounded_place * largest) return {};
  return place;
}

}  // namespace

std::map<std::size_t, Rationals> placed_nodes(const Structure& structure) {
  std::map<std::size_t, Rationals> placed;
  for (const auto& point : structure.contact)
    if (auto place = place_of(structure, point)) placed.emplace(point.node, std::move(*place));
  return placed;
}

Enclosure coordinate(const Structure& structure, std::size_t node, std::size_t axis) {
  for (const auto& point : structure.contact) {
    if (point.node != node || !place_of(structure, point)) continue;
    Enclosure sum;
    for (const auto& [other, weight] : point.against)
      sum.add_product(Enclosure(weight), Enclosure(structure.coordinates[other][axis]));
    return sum;
  }
  return Enclosure(structure.coordinates[node][axis]);
}

}  // namespace kusabi::verify
