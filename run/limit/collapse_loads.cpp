// Sums over members and loads, in the axes and units of the file.
#include "run/limit/collapse_loads.hpp"

#include <cstddef>

#include "problems/limit/utilisation.hpp"

namespace kusabi::run {

using problems::LimitProblem;
using problems::Structure;

namespace {

// Part of the loads on supported displacements, at a load factor.
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

}  // namespace

Eigen::MatrixXd load_at_collapse(const Structure& truss, const LimitProblem& problem,
                                 const limit::LimitCollapse& collapse,
                                 const Eigen::VectorXd& dead) {
  return problems::node_by_node(problem, dead + collapse.factor * problem.reference) +
         loads_on_supports(truss, collapse.factor);
}

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

}  // namespace kusabi::run
