// Bars, frames, and what belongs together; verify/plane_element.cpp has the elements.
#include "verify/assembly.hpp"

#include "verify/disjoint_sets.hpp"
#include "verify/plane_element.hpp"

namespace kusabi::verify {
namespace {

using Components = std::vector<Enclosure>;

Enclosure dot(const Components& a, const Components& b) {
  Enclosure sum;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

Components normalised(const Components& vector) {
  const auto length = sqrt(dot(vector, vector));
  Components unit;
  for (const auto& component : vector) unit.push_back(component / length);
  return unit;
}

Components components(const Vector& vector, std::size_t dimension) {
  return {vector.begin(), vector.begin() + static_cast<std::ptrdiff_t>(dimension)};
}

Components difference(const Structure& structure, const Bar& bar) {
  Components along;
  for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
    along.push_back(Enclosure(structure.places[bar.second][axis]) -
                    Enclosure(structure.places[bar.first][axis]));
  }
  return along;
}

// E A / L times the products of the direction cosines.
void add_bar(const Structure& structure, const Freedom& freedom, const Bar& bar,
             SparseEnclosure& matrix) {
  const auto d = structure.dimension;
  const auto [cosines, length] = direction(structure, bar);
  const auto stiffness = Enclosure(bar.axial_stiffness) / length;
  for (std::size_t k = 0; k < d; ++k) {
    for (std::size_t l = 0; l < d; ++l) {
      const auto entry = stiffness * cosines[k] * cosines[l];
      if (entry.is_zero()) continue;
      for (const auto row_node : {bar.first, bar.second}) {
        const auto row = freedom.number[row_node][k];
        if (row == Freedom::none) continue;
        for (const auto column_node : {bar.first, bar.second}) {
          const auto column = freedom.number[column_node][l];
          if (column == Freedom::none) continue;
          auto& sum = matrix[row][column];
          sum = row_node == column_node ? sum + entry : sum - entry;
        }
      }
    }
  }
}

}  // namespace

Direction direction(const Structure& structure, const Bar& bar) {
  const auto along = difference(structure, bar);
  Direction result;
  result.length = sqrt(dot(along, along));
  for (const auto& component : along) result.cosines.push_back(component / result.length);
  return result;
}

SparseEnclosure enclosed_stiffness(const Structure& structure, const Freedom& freedom) {
  SparseEnclosure matrix(freedom.count);
  for (const auto& bar : structure.bars) add_bar(structure, freedom, bar, matrix);
  for (const auto& element : structure.elements) add_element(structure, freedom, element, matrix);
  return matrix;
}

Frame frame(const ContactPoint& point, std::size_t dimension) {
  const auto n = normalised(components(point.normal, dimension));
  if (dimension == 2 && !point.tangent) return {n, {n[1], -n[0]}};
  Vector axis{};
  axis[point.tangent_axis] = 1;
  const auto wish = components(point.tangent.value_or(axis), dimension);
  const auto along = dot(n, wish);
  Components across;
  for (std::size_t k = 0; k < dimension; ++k) across.push_back(wish[k] - along * n[k]);
  const auto t = normalised(across);
  if (dimension == 2) return {n, t};
  return {n, t, {n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]}};
}

std::vector<std::size_t> pieces(const Structure& structure, const Freedom& freedom) {
  DisjointSets sets(freedom.count);
  const auto join = [&](const std::vector<std::size_t>& numbers) {
    for (const auto number : numbers) sets.join(number, numbers.front());
  };
  const auto free_of = [&](std::size_t node) {
    std::vector<std::size_t> numbers;
    for (const auto number : freedom.number[node]) {
      if (number != Freedom::none) numbers.push_back(number);
    }
    return numbers;
  };
  for (const auto& bar : structure.bars) {
    std::vector<std::size_t> straining;
    for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
      if (structure.places[bar.first][axis] == structure.places[bar.second][axis]) continue;
      for (const auto node : {bar.first, bar.second}) {
        const auto number = freedom.number[node][axis];
        if (number != Freedom::none) straining.push_back(number);
      }
    }
    join(straining);
  }
  for (const auto& element : structure.elements) {
    std::vector<std::size_t> moving;
    for (const auto node : element.nodes) {
      for (const auto number : free_of(node)) moving.push_back(number);
    }
    join(moving);
  }
  for (const auto& point : structure.contact) join(free_of(point.node));
  std::map<std::size_t, std::size_t> first;  // candidate of each set
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const auto set = sets.of(freedom.number[structure.contact[i].node][0]);
    result.push_back(first.emplace(set, i).first->second);
  }
  return result;
}

}  // namespace kusabi::verify
