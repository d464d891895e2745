// The weights of the relative rule, and what the rules make of a node that is solved.
#include "nodes/wedged/branching.hpp"

namespace kusabi::wedged {

namespace {

std::vector<double> weights(const problems::WedgedProblem& problem,
                            std::span<const double> friction, Branching branching) {
  std::vector<double> weights(friction.size(), 1);
  if (branching == Branching::product) return weights;
  const Eigen::Index d = problem.dimension;
  for (std::size_t i = 0; i < friction.size(); ++i) {
    const Eigen::Index normal = d * static_cast<Eigen::Index>(i);
    const auto own = problem.compliance.row(normal).segment(normal, d);
    weights[i] = 1 / (own[0] + friction[i] * own.tail(d - 1).norm());
  }
  return weights;
}

}  // namespace

BranchingRule::BranchingRule(const problems::WedgedProblem& problem,
                             std::span<const double> friction, Branching branching)
    : deepest_(branching == Branching::deepest), weight_(weights(problem, friction, branching)) {}

int BranchingRule::candidate(const support::IndexSet& open, ContactSolver& solver) const {
  if (deepest_) {
    const auto distances = solver.face_distances();
    if (!distances.empty())
      return largest(open, [&](int i) {
        const auto& own = distances[static_cast<std::size_t>(i)];
        return own.separation * own.contact;
      });
  }
  return most_violated(open, [&](int i) { return solver.violation(i); });
}

}  // namespace kusabi::wedged
