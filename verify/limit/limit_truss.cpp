// Columns of B by member, loads by free displacement.
#include "verify/limit/limit_truss.hpp"

#include "verify/limit/exact_truss.hpp"
#include "verify/structure/assembly.hpp"

namespace kusabi::verify {
namespace {

// The middle of an enclosure, and its distance from the bounds.
Approximate middle(const Enclosure& value) {
  const auto sum = (value.lower() + value.upper()).scaled(-1);
  return {sum, value.distance(sum)};
}

}  // namespace

std::optional<LimitTruss> limit_truss(const Structure& structure, double sudden) {
  const Freedom freedom(structure);
  LimitTruss truss;
  const mpq_class divisor(sudden);
  for (const auto& bar : structure.bars) {
    auto& column = truss.columns.emplace_back();
    const auto cosines = direction(structure, bar).cosines;
    for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
      if (!cosines[axis].finite()) return {};
      if (cosines[axis].is_zero()) continue;
      if (const auto e = freedom.number[bar.first][axis]; e != Freedom::none)
        column.emplace_back(e, middle(-cosines[axis]));
      if (const auto e = freedom.number[bar.second][axis]; e != Freedom::none)
        column.emplace_back(e, middle(cosines[axis]));
    }
    const mpq_class tension = mpq_class(bar.tension) / divisor;
    const mpq_class compression = mpq_class(bar.compression) / divisor;
    truss.below.tension.push_back(rounded_down(tension));
    truss.below.compression.push_back(rounded_down(compression));
    truss.above.tension.push_back(rounded_up(tension));
    truss.above.compression.push_back(rounded_up(compression));
    truss.names.push_back(structure.names[bar.first] + "-" + structure.names[bar.second]);
  }
  truss.dead = sum_of<Dyadic>(structure.dead, structure, freedom);
  truss.reference = sum_of<Dyadic>(structure.reference, structure, freedom);
  truss.uncertain = uncertain_columns(structure, freedom);
  for (const auto& half_width : structure.half_widths)
    truss.alpha.push_back(half_width.value_or(0));
  return truss;
}

Strengths LimitTruss::remaining(const std::vector<std::size_t>& lost) const {
  auto left = above;
  for (const auto member : lost) left.tension[member] = left.compression[member] = 0;
  return left;
}

Dyadic elongation_of(const TrussColumn& column, const std::vector<Dyadic>& motion) {
  Dyadic total;
  for (const auto& [e, entry] : column) total = total + entry.value * motion[e];
  return total;
}

}  // namespace kusabi::verify
