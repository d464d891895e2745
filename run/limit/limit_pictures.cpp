// Loads, motion and axial forces of a collapse, on the grid of the truss.
#include "run/limit/limit_pictures.hpp"

#include <array>
#include <string>

#include <fmt/format.h>

#include "pictures/vtu/structure_grid.hpp"
#include "problems/limit/collapse_mode.hpp"
#include "problems/limit/utilisation.hpp"
#include "run/output/values.hpp"
#include "run/pictures/vtu_series.hpp"

namespace kusabi::run {
namespace {

using problems::LimitProblem;
using problems::Structure;

// What the supports must do: whatever load and members leave along an axis that is fixed.
Eigen::MatrixXd support_reactions(const Structure& truss, const Eigen::MatrixXd& load,
                                  const Eigen::VectorXd& forces) {
  Eigen::MatrixXd rest = load;
  for (std::size_t i = 0; i < truss.members.size(); ++i) {
    const auto& member = truss.members[i];
    const Eigen::VectorXd along =
        (truss.coordinates.col(member.second) - truss.coordinates.col(member.first)).normalized();
    const Eigen::VectorXd pull = forces(static_cast<Eigen::Index>(i)) * along;
    rest.col(member.first) += pull;
    rest.col(member.second) -= pull;
  }
  for (Eigen::Index node = 0; node < rest.cols(); ++node) {
    const auto& fixed = truss.fixed[static_cast<std::size_t>(node)];
    for (Eigen::Index axis = 0; axis < rest.rows(); ++axis)
      rest(axis, node) = fixed[static_cast<std::size_t>(axis)] ? -rest(axis, node) : 0;
  }
  return rest;
}

// The part of the loads that acts on supported displacements, at a factor.
Eigen::MatrixXd loads_on_supports(const Structure& truss, double factor) {
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(truss.dimension, truss.coordinates.cols());
  for (const auto& load : truss.loads) {
    for (int axis = 0; axis < truss.dimension; ++axis) {
      const bool fixed =
          truss.fixed[static_cast<std::size_t>(load.node)][static_cast<std::size_t>(axis)];
      if (!fixed) continue;
      loads(axis, load.node) +=
          (load.kind == problems::Load::Kind::reference ? factor : 1) * load.force(axis);
    }
  }
  return loads;
}

pictures::UnstructuredGrid collapse_grid(const Structure& truss, const LimitProblem& problem,
                                         const limit::LimitCollapse& collapse,
                                         const Eigen::VectorXd& dead, const std::string& remark) {
  const auto by_node = [&](const Eigen::VectorXd& vector) {
    return problems::node_by_node(problem, vector);
  };
  auto grid = pictures::structure_grid(truss);
  grid.remark =
      fmt::format("{}: {}; {} and {}", truss.name, remark, truss.units.length, truss.units.force);
  const Eigen::MatrixXd load = by_node(dead + collapse.factor * problem.reference) +
                               loads_on_supports(truss, collapse.factor);
  auto& points = grid.point_data;
  points.push_back(pictures::node_vectors("velocity", by_node(collapse.motion)));
  points.push_back(pictures::node_vectors("dead_load", by_node(dead)));
  points.push_back(pictures::node_vectors("reference_load", by_node(problem.reference)));
  points.push_back(pictures::node_vectors("load", load));
  points.push_back(
      pictures::node_vectors("support_reaction", support_reactions(truss, load, collapse.forces)));
  const auto add = [&](const char* name, const Eigen::VectorXd& values) {
    grid.cell_data.push_back(pictures::member_numbers(grid, name, numbers(values)));
  };
  add("axial_force", collapse.forces);
  add("utilisation", problems::utilisation(problem, collapse.forces));
  add("elongation_rate", problem.equilibrium.transpose() * collapse.motion);
  return grid;
}

}  // namespace

void draw_collapses(OutputFolder& folder, const LimitReport& report) {
  const auto& [options, truss, problem, answer, ranks] = report;
  VtuSeries series(folder);
  if (answer.nominal) {
    series.add("nominal.vtu",
               collapse_grid(truss, problem, *answer.nominal, problem.dead,
                             fmt::format("collapse at load factor {}", answer.nominal->factor)));
  }
  if (answer.worst && answer.worst->collapse) {
    const auto& collapse = *answer.worst->collapse;
    series.add("worst-case.vtu",
               collapse_grid(
                   truss, problem, collapse, problems::dead_load(problem, answer.worst->zeta),
                   fmt::format("collapse in the worst case, at load factor {}", collapse.factor)));
  }
  series.finish("limit.pvd", problem.name);
}

}  // namespace kusabi::run
