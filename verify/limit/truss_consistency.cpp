// Members are compared first, then loads.
#include "verify/limit/truss_consistency.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "support/one_line.hpp"
#include "verify/limit/exact_truss.hpp"

namespace kusabi::verify {
namespace {

/// Column of T, by displacement, its name and its half-width, which are matched in any order.
using Column = std::tuple<Sparse, std::string, double>;

std::vector<Column> columns_of(const Structure& structure) {
  std::vector<Column> columns;
  for (auto& column : uncertain_columns(structure, Freedom(structure))) {
    const auto j = columns.size();
    std::ranges::sort(column);
    columns.emplace_back(std::move(column),
                         structure.load_names.empty()
                             ? std::string()
                             : support::on_one_line(structure.load_names[j]),
                         structure.half_widths.empty() ? 0 : structure.half_widths[j].value_or(0));
  }
  return columns;
}

}  // namespace

std::optional<std::string> uncertain_difference(const Structure& recorded, const Structure& file) {
  const std::string others = "the recorded uncertain loads are not those of the truss";
  const auto own = columns_of(recorded);
  std::multiset<Column> left(own.begin(), own.end());
  const auto columns = columns_of(file);
  // Equal columns with specified half-widths are matched first.
  for (const bool specified : {true, false}) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if ((j < file.half_widths.size() && file.half_widths[j].has_value()) != specified) continue;
      const auto& [column, name, half_width] = columns[j];
      const auto any = left.lower_bound({column, name, 0});
      const bool known =
          any != left.end() && std::get<0>(*any) == column && std::get<1>(*any) == name;
      const auto found = specified && known ? left.find(columns[j]) : any;
      if (!known) return others;
      if (found == left.end())
        return "the recorded half-width of an uncertain load is not that of the truss";
      left.erase(found);
    }
  }
  return left.empty() ? std::nullopt : std::optional(others);
}

std::optional<std::string> truss_difference(const TrussTheorem& theorem, const Structure& file) {
  const auto& recorded = theorem.truss;
  if (!Freedom(file).masters.empty() || !file.ties.empty())
    return "the structure has multi-point constraints, inclined supports or contact pairs; "
           "limit analysis does not support these";
  const auto own = exact_truss(recorded);
  const auto other = exact_truss(file);
  const auto sizes = [](const ExactTruss& truss) {
    return std::to_string(truss.displacements) + " displacements and " +
           std::to_string(truss.members()) + " members";
  };
  if (sizes(own) != sizes(other))
    return "the certificate has " + sizes(own) + ", the truss has " + sizes(other);
  if (recorded.coordinates.size() != file.coordinates.size())
    return "the certificate has another number of nodes than the truss";
  for (std::size_t node = 0; node < file.coordinates.size(); ++node) {
    for (std::size_t axis = 0; axis < file.dimension; ++axis) {
      if (recorded.coordinates[node][axis] != file.coordinates[node][axis] ||
          recorded.fixed[node][axis] != file.fixed[node][axis])
        return "the recorded place or support of node " + file.names[node] +
               " is not that of the truss";
    }
  }
  for (std::size_t i = 0; i < file.bars.size(); ++i) {
    const auto& bar = file.bars[i];
    const auto& its = recorded.bars[i];
    const auto name = file.names[bar.first] + "-" + file.names[bar.second];
    if (std::tie(its.first, its.second) != std::tie(bar.first, bar.second))
      return "the recorded nodes of member " + name + " are not those of the truss";
    if (std::tie(its.tension, its.compression, its.residual) !=
        std::tie(bar.tension, bar.compression, bar.residual))
      return "the recorded yield forces of member " + name + " are not those of the truss";
  }
  if (own.dead != other.dead) return "the recorded dead load is not that of the truss";
  if (own.reference != other.reference)
    return "the recorded reference load is not that of the truss";
  if (theorem.losses > 0 && recorded.uncertain->empty()) return {};
  return uncertain_difference(recorded, file);
}

Structure with_reversed_reference(Structure structure) {
  for (auto& force : structure.reference) {
    for (double& component : force.components) component = -component;
  }
  return structure;
}

Structure truss_of(const TrussTheorem& theorem) {
  auto truss =
      theorem.claim == LimitClaim::minimum ? with_reversed_reference(theorem.truss) : theorem.truss;
  if (theorem.residual) {
    for (auto& bar : truss.bars) bar.compression = bar.residual;
  }
  return truss;
}

}  // namespace kusabi::verify
