// Coordinates, yield forces and loads are the doubles of the problem file.
#include "verify/limit/exact_truss.hpp"

namespace kusabi::verify {
ExactTruss exact_truss(const Structure& structure) {
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
    truss.tension.emplace_back(bar.tension);
    truss.compression.emplace_back(bar.compression);
  }
  truss.dead = sum_of<mpq_class>(structure.dead, structure, freedom);
  truss.reference = sum_of<mpq_class>(structure.reference, structure, freedom);
  return truss;
}

void add_uncertain(const std::vector<Sparse>& columns, const std::vector<double>& alpha,
                   ExactTruss& truss) {
  for (std::size_t j = 0; j < columns.size(); ++j) {
    auto& load = truss.uncertain.emplace_back();
    for (const auto& [e, value] : columns[j])
      load.emplace_back(e, mpq_class(value) * mpq_class(alpha[j]));
  }
}

}  // namespace kusabi::verify
