// One solver or the other.
#include "nodes/contact_solver.hpp"

namespace kusabi::nodes {

ContactSolver::ContactSolver(const problems::WedgedProblem& problem,
                             std::span<const double> friction, conic::Tolerances tolerances)
    : dimension_(problem.dimension),
      unit_(problems::mean_normal_compliance(problem)),
      solver_([&]() -> decltype(solver_) {
        const Eigen::MatrixXd scaled = problem.compliance / unit_;
        if (problem.dimension == 2) return conic::NodeSolver<2>(scaled, friction, tolerances);
        return conic::NodeSolver<3>(scaled, friction, tolerances);
      }()) {}

void ContactSolver::set_friction(std::span<const double> friction) {
  std::visit([&](auto& solver) { solver.set_friction(friction); }, solver_);
}

conic::Answer ContactSolver::solve(std::uint64_t contact, std::uint64_t separated,
                                   conic::StopEarly stop) {
  return std::visit([&](auto& solver) { return solver.solve(contact, separated, stop); }, solver_);
}

const Eigen::VectorXd& ContactSolver::reaction() const {
  return std::visit([](const auto& solver) -> const Eigen::VectorXd& { return solver.reaction(); },
                    solver_);
}

const Eigen::VectorXd& ContactSolver::displacement() const {
  return std::visit(
      [](const auto& solver) -> const Eigen::VectorXd& { return solver.displacement(); }, solver_);
}

const Eigen::VectorXd& ContactSolver::multipliers() const {
  return std::visit(
      [](const auto& solver) -> const Eigen::VectorXd& { return solver.multipliers(); }, solver_);
}

}  // namespace kusabi::nodes
