// The weights of the relative rule.
#include "nodes/wedged/branching.hpp"

namespace kusabi::wedged {

std::vector<double> branching_weights(const problems::WedgedProblem& problem,
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

}  // namespace kusabi::wedged
