// Conversion of units, and shares of cuts that are large enough.
#include "nodes/limit/search/limit_evidence.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "verify/limit/truss_consistency.hpp"

namespace kusabi::limit {
namespace {

using problems::LimitModel;

/// The shares of the cuts of a column sum to alpha times its weight up to rounding; a proof
/// requires at least that. The margin of the solver is far larger.
constexpr double enough = 1 + 1e-13;

/// A force this close to a yield force, in the unit of the member, is equal to it: an idle cable
/// has no margin, and the proof needs exact equilibrium.
constexpr double at_yield = 1e-12;

/// A smaller force, in the unit of the member, is a rounding error: where equilibrium makes the
/// forces at a node zero and a member has no margin, the proof needs them exactly.
constexpr double rounding = 1e-14;

// B~ y~ - k~ f~_R = d~_j, row e being in units of Y_e.
verify::LimitCut cut_of(const StaticCut& cut, const LimitModel& model) {
  const double unit = model.direction_unit(cut.column);
  verify::LimitCut result;
  result.column = static_cast<std::size_t>(cut.column);
  result.factor = cut.factor * model.factor_unit / unit;
  for (const auto& [member, force] : cut.forces) {
    result.forces.emplace_back(static_cast<std::size_t>(member),
                               force * model.member_unit(member) / unit);
  }
  return result;
}

double snapped(double force, double tension, double compression, double unit) {
  const double near = at_yield * unit;
  if (std::abs(force) <= rounding * unit) return 0;
  if (std::abs(force - tension) <= near) return tension;
  if (std::abs(force + compression) <= near) return -compression;
  return force;
}

class Converter {
 public:
  Converter(const problems::LimitProblem& problem, const LimitModel& model, double alpha)
      : problem_(problem), model_(model), alpha_(alpha) {}

  // @param columns the column of T of each of the node's cuts; its own come last
  verify::LimitNode node_of(const ClosedNode& node, const std::vector<std::size_t>& places,
                            const std::vector<std::size_t>& columns) const;

 private:
  const problems::LimitProblem& problem_;
  const LimitModel& model_;
  double alpha_;
};

verify::LimitNode Converter::node_of(const ClosedNode& node, const std::vector<std::size_t>& places,
                                     const std::vector<std::size_t>& columns) const {
  verify::LimitNode result;
  result.signs.assign(node.signs.begin(), node.signs.end());
  result.factor = node.factor * model_.factor_unit;
  const auto forces = problems::forces_in_units(
      model_, Eigen::Map<const Eigen::VectorXd>(node.forces.data(), model_.member_count()));
  for (int i = 0; i < model_.member_count(); ++i) {
    result.forces.push_back(
        snapped(forces(i), problem_.tension(i), problem_.compression(i), model_.member_unit(i)));
  }
  const auto unit_of = [this](std::size_t j) {
    return model_.direction_unit(static_cast<Eigen::Index>(j));
  };
  std::vector<double> sum(node.signs.size());
  for (std::size_t c = 0; c < node.mu.size(); ++c) {
    sum[columns[c]] += node.mu[c] * unit_of(columns[c]);
  }
  for (std::size_t c = 0; c < node.mu.size(); ++c) {
    const auto j = columns[c];
    if (node.signs[j] != 0) continue;  // gamma_j does not occur
    const double needed = alpha_ * problem_.uncertain[j].reach() * enough;
    double share = node.mu[c] * unit_of(j);
    if (sum[j] < needed / 2) {
      // The simplex method drops tiny shares: any cut is given the rest.
      share += needed - sum[j];
      sum[j] = needed;
    } else {
      share *= std::max(1.0, needed / sum[j]);
    }
    if (share != 0) result.shares.emplace_back(places[c], share);
  }
  for (std::size_t j = 0; j < node.one_sided.size(); ++j) {
    result.one_sided.push_back(node.one_sided[j] * unit_of(j));
  }
  return result;
}

}  // namespace

verify::TrussTheorem theorem_of(const problems::LimitProblem& problem, const LimitModel& model,
                                double alpha, const Worst& worst,
                                const std::vector<StaticCut>& root_cuts,
                                const std::vector<ClosedNode>& nodes) {
  verify::TrussTheorem theorem;
  theorem.collapse = collapse_of(problem, alpha, {}, worst.zeta,
                                 problems::motion_in_units(model, worst.collapse.motion));
  std::vector<std::size_t> shared_places;
  std::vector<std::size_t> shared_columns;
  const auto add = [&](const StaticCut& cut, auto& places, auto& columns) {
    places.push_back(theorem.cuts.size());
    columns.push_back(static_cast<std::size_t>(cut.column));
    theorem.cuts.push_back(cut_of(cut, model));
  };
  for (const auto& cut : root_cuts) add(cut, shared_places, shared_columns);
  const Converter converter(problem, model, alpha);
  for (const auto& node : nodes) {
    auto places = shared_places;
    auto columns = shared_columns;
    for (const auto& cut : node.own_cuts) add(cut, places, columns);
    theorem.nodes.push_back(converter.node_of(node, places, columns));
  }
  return theorem;
}

void of_least_factors(verify::TrussTheorem& theorem) {
  theorem.claim = verify::LimitClaim::minimum;
  theorem.truss = verify::with_reversed_reference(std::move(theorem.truss));
}

verify::LimitNode limit_node(const problems::LimitProblem& problem, const LimitModel& model,
                             double alpha, std::span<const StaticCut> cuts,
                             const ClosedNode& node) {
  std::vector<std::size_t> places;
  std::vector<std::size_t> columns;
  for (const auto& cut : cuts) {
    places.push_back(places.size());
    columns.push_back(static_cast<std::size_t>(cut.column));
  }
  return Converter(problem, model, alpha).node_of(node, places, columns);
}

verify::CollapseMotion collapse_of(const problems::LimitProblem& problem, double alpha,
                                   std::vector<std::size_t> lost, const Eigen::VectorXd& zeta,
                                   const Eigen::VectorXd& motion) {
  verify::CollapseMotion collapse{std::move(lost), {}, {motion.begin(), motion.end()}};
  for (Eigen::Index j = 0; j < zeta.size(); ++j) {
    const double maximum = alpha * problem.uncertain[static_cast<std::size_t>(j)].half_width;
    collapse.load.push_back(zeta(j) == 0 ? 0 : std::copysign(maximum, zeta(j)));
  }
  return collapse;
}

std::optional<verify::Structure> with_loads(verify::Structure truss,
                                            const problems::LimitProblem& problem, double alpha) {
  auto file = truss;
  file.half_widths.clear();  // on a curve those of the search are not those of the file
  truss.uncertain.emplace();
  truss.half_widths.clear();
  truss.load_names.clear();
  for (const auto& column : problem.uncertain) {
    auto& load = truss.uncertain->emplace_back();
    for (const auto& [degree, value] : column.direction) {
      const auto& free = problem.degrees.free[static_cast<std::size_t>(degree)];
      load.push_back({static_cast<std::size_t>(free.node), static_cast<std::size_t>(free.axis),
                      column.weight * value});
    }
    // Exact: either half-widths or alpha are 1, except on a curve.
    truss.half_widths.emplace_back(alpha * column.half_width);
    truss.load_names.push_back(column.group.empty() ? column.name : column.group);
  }
  if (verify::uncertain_difference(truss, file)) return {};
  return truss;
}

}  // namespace kusabi::limit
