// Solutions of node programs as configurations and as evidence.
#include "nodes/wedged/relaxation/block_relaxation.hpp"

#include <utility>

#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

BlockRelaxation::BlockRelaxation(const problems::WedgedProblem& problem,
                                 support::IndexSet within_whole, std::span<const double> friction,
                                 const SignPatternOptions& options)
    : candidates(std::move(within_whole)),
      all(problems::all_candidates(problem)),
      rule(problem, friction, options.branching),
      solver(problem, friction, options.tolerances, options.precision),
      mean_motion(problem) {
  if (options.facets != 0)
    outer.emplace(problem.compliance.matrix / solver.unit(), friction, options.facets,
                  options.tolerances, problem.compliance.error, problem.modes.matrix,
                  problem.modes.error);
}

SignPattern BlockRelaxation::in_whole(const SignPattern& own) const {
  return {.contact = problems::in_whole(own.contact, candidates),
          .separated = problems::in_whole(own.separated, candidates),
          .inactive = problems::in_whole(own.inactive, candidates)};
}

Configuration BlockRelaxation::configuration(const PatternNode& node, LeafState state,
                                             const conic::ConicResult& answer) const {
  const Eigen::VectorXd& r = solver.reaction();
  const Eigen::VectorXd u = solver.unit() * solver.displacement();
  return {.block = node.block,
          .pattern = in_whole(node.pattern),
          .state = state,
          .lower = answer.lower,
          .upper = answer.upper,
          .reaction = {r.begin(), r.end()},
          .displacement = {u.begin(), u.end()}};
}

std::vector<double> BlockRelaxation::feasible_numbers(const PatternNode& node,
                                                      const Configuration& leaf) const {
  std::vector<double> numbers;  // tangential reactions first
  for (const int touching : node.pattern.contact) {
    const auto* const normal = leaf.reaction.data() + solver.normal(touching);
    numbers.insert(numbers.end(), normal + 1, normal + solver.dimension());
  }
  const Eigen::Map<const Eigen::VectorXd> u(leaf.displacement.data(),
                                            static_cast<Eigen::Index>(leaf.displacement.size()));
  const auto mean = mean_motion.of(u);
  numbers.insert(numbers.end(), mean.begin(), mean.end());
  return numbers;
}

}  // namespace kusabi::wedged
