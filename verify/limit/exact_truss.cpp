// Coordinates, yield forces and loads are the doubles of the problem file.
#include "verify/limit/exact_truss.hpp"

namespace kusabi::verify {

// Loads on a support act on the ground.
std::vector<Sparse> uncertain_columns(const Structure& structure, const Freedom& freedom) {
  std::vector<Sparse> columns;
  if (structure.uncertain) {
    for (const auto& parameter : *structure.uncertain) {
      auto& column = columns.emplace_back();
      for (const auto& [node, axis, weight] : parameter) {
        const auto number = freedom.number[node][axis];
        if (number != Freedom::none) column.emplace_back(number, weight);
      }
    }
    return columns;
  }
  const auto dead = sum_of<double>(structure.dead, structure, freedom);
  const auto reference = sum_of<double>(structure.reference, structure, freedom);
  for (std::size_t e = 0; e < freedom.count; ++e) {
    if (dead[e] == 0 && reference[e] == 0) columns.push_back({{e, 1.0}});
  }
  return columns;
}

ExactTruss exact_truss(const Structure& structure, double sudden) {
  const Freedom freedom(structure);
  ExactTruss truss;
  truss.displacements = freedom.count;
  for (const auto& bar : structure.bars) {
    auto& column = truss.columns.emplace_back();
    auto& square = truss.square_lengths.emplace_back();
    for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
      const mpq_class along = mpq_class(structure.coordinates[bar.second][axis]) -
                              mpq_class(structure.coordinates[bar.first][axis]);
      if (sgn(along) == 0) continue;
      square += along * along;
      if (const auto number = freedom.number[bar.first][axis]; number != Freedom::none)
        column.emplace_back(number, -along);
      if (const auto number = freedom.number[bar.second][axis]; number != Freedom::none)
        column.emplace_back(number, along);
    }
    truss.tension.emplace_back(mpq_class(bar.tension) / mpq_class(sudden));
    truss.compression.emplace_back(mpq_class(bar.compression) / mpq_class(sudden));
  }
  truss.dead = sum_of<mpq_class>(structure.dead, structure, freedom);
  truss.reference = sum_of<mpq_class>(structure.reference, structure, freedom);
  if (!structure.uncertain) return truss;
  const auto columns = uncertain_columns(structure, freedom);
  for (std::size_t j = 0; j < structure.half_widths.size(); ++j) {
    auto& load = truss.uncertain.emplace_back();
    for (const auto& [e, value] : columns[j])
      load.emplace_back(e, mpq_class(value) * mpq_class(structure.half_widths[j].value_or(0)));
  }
  return truss;
}

}  // namespace kusabi::verify
