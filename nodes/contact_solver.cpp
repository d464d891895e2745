// One solver or the other.
#include "nodes/contact_solver.hpp"

#include <algorithm>
#include <vector>

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
                                   conic::StopEarly stop, std::uint64_t ignored) {
  if (ignored != 0) return {};
  return std::visit([&](auto& solver) { return solver.solve(contact, separated, stop); }, solver_);
}

std::optional<RelativeInterior> ContactSolver::relative_interior(std::uint64_t contact,
                                                                 std::uint64_t separated) {
  solve(contact, separated, {.when_dead = false, .when_alive = false});
  RelativeInterior inside;
  const auto candidates = reaction().size() / dimension_;
  std::vector<double> sizes{1e-14};
  for (int i = 0; i < candidates; ++i) {
    if ((separated >> i & 1) == 0) sizes.push_back(std::max(1e-14, normal_reaction(i)));
    if ((contact >> i & 1) == 0) sizes.push_back(std::max(1e-14, normal_displacement(i)));
  }
  std::sort(sizes.begin(), sizes.end());
  double widest = 1e3, least = 0;
  for (std::size_t k = 0; k + 1 < sizes.size(); ++k) {
    if (sizes[k] < 1e-5 && sizes[k + 1] / sizes[k] > widest) {
      widest = sizes[k + 1] / sizes[k];
      least = sizes[k + 1];
    }
  }
  if (least == 0) return std::nullopt;
  for (int i = 0; i < candidates; ++i) {
    if ((separated >> i & 1) == 0 && normal_reaction(i) >= least) inside.loaded |= 1ULL << i;
    if ((contact >> i & 1) == 0 && normal_displacement(i) >= least) inside.moved |= 1ULL << i;
  }
  return inside;
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
