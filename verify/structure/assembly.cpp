// Assembly of bars, springs, given stiffnesses and contact frames. Elements are in
// verify/structure/solid_element.cpp.
#include "verify/structure/assembly.hpp"

#include <set>
#include <utility>

#include "verify/arithmetic/disjoint_sets.hpp"
#include "verify/structure/placed_nodes.hpp"
#include "verify/structure/solid_element.hpp"

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
    along.push_back(coordinate(structure, bar.second, axis) -
                    coordinate(structure, bar.first, axis));
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
      for (const auto row : {bar.first, bar.second}) {
        for (const auto column : {bar.first, bar.second})
          freedom.add({row, k}, {column, l}, row == column ? entry : -entry, matrix);
      }
    }
  }
}

// Free displacements of each row of a stiffness of another program, with their weights.
std::vector<std::vector<std::pair<std::size_t, Enclosure>>> rows_of(const Structure& structure,
                                                                    const Freedom& freedom,
                                                                    std::size_t index) {
  std::vector<std::vector<std::pair<std::size_t, Enclosure>>> rows;
  for (const auto& [node, axis] : structure.given[index].rows) {
    if (node) {
      rows.push_back(freedom.weighted(*node, axis));
    } else {
      rows.push_back({{freedom.internal[index][rows.size()], Enclosure(1)}});
    }
  }
  return rows;
}

void add_given(const Structure& structure, const Freedom& freedom, std::size_t index,
               SparseEnclosure& matrix) {
  const auto rows = rows_of(structure, freedom, index);
  for (const auto& entry : structure.given[index].entries) {
    for (const auto& [row, weight] : rows[entry.row]) {
      for (const auto& [column, other] : rows[entry.column])
        matrix[row][column] += Enclosure(entry.value) * weight * other;
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
  for (const auto& [node, axis, stiffness] : structure.springs)
    freedom.add({node, axis}, {node, axis}, Enclosure(stiffness), matrix);
  for (std::size_t index = 0; index < structure.given.size(); ++index)
    add_given(structure, freedom, index, matrix);
  return matrix;
}

Frame frame(const ContactPoint& point, std::size_t dimension) {
  const auto n = normalised(components(point.normal, dimension));
  if (dimension == 2 && !point.tangent) return {n, {n[1], -n[0]}};
  Vector axis{};
  axis[point.tangent_axis] = 1;
  const auto unprojected = components(point.tangent.value_or(axis), dimension);
  const auto along = dot(n, unprojected);
  Components across;
  for (std::size_t k = 0; k < dimension; ++k) across.push_back(unprojected[k] - along * n[k]);
  const auto t = normalised(across);
  if (dimension == 2) return {n, t};
  return {n, t, {n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]}};
}

namespace {

// The connected components of free displacements, and one displacement of each candidate.
struct Connected {
  DisjointSets sets;
  std::vector<std::size_t> own;
};

Connected connected(const Structure& structure, const Freedom& freedom) {
  DisjointSets sets(freedom.count);
  const auto join = [&](const std::vector<std::size_t>& numbers) {
    for (const auto number : numbers) sets.join(number, numbers.front());
  };
  for (const auto& bar : structure.bars) {
    std::vector<std::size_t> straining;
    for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
      if (structure.coordinates[bar.first][axis] == structure.coordinates[bar.second][axis])
        continue;
      for (const auto node : {bar.first, bar.second}) {
        for (const auto number : freedom.parts(node, axis)) straining.push_back(number);
      }
    }
    join(straining);
  }
  for (const auto& element : structure.elements) {
    std::vector<std::size_t> moving;
    for (const auto node : element.nodes) {
      for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
        for (const auto number : freedom.parts(node, axis)) moving.push_back(number);
      }
    }
    join(moving);
  }
  for (const auto& spring : structure.springs) join(freedom.parts(spring.node, spring.axis));
  for (std::size_t index = 0; index < structure.given.size(); ++index) {
    const auto rows = rows_of(structure, freedom, index);
    for (const auto& entry : structure.given[index].entries) {
      std::vector<std::size_t> resisted;
      for (const auto place : {entry.row, entry.column}) {
        for (const auto& [number, weight] : rows[place]) resisted.push_back(number);
      }
      if (!rows[entry.row].empty() && !rows[entry.column].empty()) join(resisted);
    }
  }
  std::vector<std::size_t> own;  // one displacement of each candidate
  const auto shared = shared_nodes(structure);
  for (const auto& point : structure.contact) {
    std::vector<std::size_t> moving;
    for (const auto number : freedom.number[point.node]) {
      if (number != Freedom::none) moving.push_back(number);
    }
    for (std::size_t axis = 0; axis < structure.dimension && shared.contains(point.node); ++axis) {
      for (const auto& [master, weight] : point.against) {
        for (const auto number : freedom.parts(master, axis)) moving.push_back(number);
      }
    }
    join(moving);
    own.push_back(moving.front());
  }
  return {std::move(sets), std::move(own)};
}

}  // namespace

std::vector<std::size_t> pieces(const Structure& structure, const Freedom& freedom) {
  auto [sets, own] = connected(structure, freedom);
  std::map<std::size_t, std::size_t> first;  // first candidate of each set
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const auto set = sets.of(own[i]);
    result.push_back(first.emplace(set, i).first->second);
  }
  return result;
}

std::vector<bool> touched(const Structure& structure, const Freedom& freedom,
                          const std::vector<Force>& load) {
  auto [sets, own] = connected(structure, freedom);
  std::set<std::size_t> loaded;
  for (const auto& [node, components] : load) {
    for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
      if (components[axis] == 0) continue;
      for (const auto number : freedom.parts(node, axis)) loaded.insert(sets.of(number));
    }
  }
  std::vector<bool> result;
  result.reserve(own.size());
  for (const auto number : own) result.push_back(loaded.contains(sets.of(number)));
  return result;
}

}  // namespace kusabi::verify
