// Weights of the relative rule, and the choice of each rule at a solved node.
#include "nodes/wedged/relaxation/branching.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace kusabi::wedged {

namespace {

std::vector<double> weights(const problems::WedgedProblem& problem,
                            std::span<const double> friction) {
  std::vector<double> weights(friction.size());
  const Eigen::Index d = problem.dimension;
  for (std::size_t i = 0; i < friction.size(); ++i) {
    const Eigen::Index normal = d * static_cast<Eigen::Index>(i);
    const auto own = problem.compliance.matrix.row(normal).segment(normal, d);
    weights[i] = 1 / (own[0] + friction[i] * own.tail(d - 1).norm());
  }
  return weights;
}

}  // namespace

BranchingRule::BranchingRule(const problems::WedgedProblem& problem,
                             std::span<const double> friction, Branching branching)
    : branching_(branching), weight_(weights(problem, friction)) {}

std::vector<int> BranchingRule::best(const support::IndexSet& undecided, ContactSolver& solver,
                                     int count) const {
  const auto ranked = [&](const auto& score) {
    std::vector<int> first;
    for (auto left = undecided; !left.empty() && std::ssize(first) < count;) {
      first.push_back(largest(left, score));
      left = left - support::IndexSet::single(first.back());
    }
    return first;
  };
  const auto relative = [&](int i) { return solver.violation(i) * weight(i); };
  if (branching_ == Branching::deepest || branching_ == Branching::weighed) {
    const auto distances = solver.face_distances();
    const auto product = [&](int i) {
      const auto& own = distances[static_cast<std::size_t>(i)];
      return own.separation * own.contact;
    };
    const auto weighed = [&](int i) { return product(i) * std::sqrt(std::max(0.0, relative(i))); };
    if (!distances.empty())
      return branching_ == Branching::deepest ? ranked(product) : ranked(weighed);
  }
  return ranked(relative);
}

}  // namespace kusabi::wedged
