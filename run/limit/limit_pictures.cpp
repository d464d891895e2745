// Loads, collapse mode and axial forces on the grid of the truss.
#include "run/limit/limit_pictures.hpp"

#include <string>

#include <fmt/format.h>

#include "pictures/vtu/structure_grid.hpp"
#include "problems/limit/collapse_mode.hpp"
#include "problems/limit/utilisation.hpp"
#include "run/limit/collapse_loads.hpp"
#include "run/output/values.hpp"
#include "run/pictures/vtu_series.hpp"

namespace kusabi::run {
namespace {

using problems::LimitProblem;
using problems::Structure;

pictures::UnstructuredGrid collapse_grid(const Structure& truss, const LimitProblem& problem,
                                         const limit::LimitCollapse& collapse,
                                         const Eigen::VectorXd& dead, const std::string& remark) {
  const auto by_node = [&](const Eigen::VectorXd& vector) {
    return problems::node_by_node(problem, vector);
  };
  auto grid = pictures::structure_grid(truss);
  grid.remark =
      fmt::format("{}: {}; {} and {}", truss.name, remark, truss.units.length, truss.units.force);
  const auto load = load_at_collapse(truss, problem, collapse, dead);
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
  const auto& truss = report.truss;
  const auto& problem = report.problem;
  const auto& answer = report.answer;
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
