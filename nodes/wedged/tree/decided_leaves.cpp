// One cone program for each leaf.
#include "nodes/wedged/tree/decided_leaves.hpp"

#include <utility>

#include "nodes/wedged/tree/sign_pattern_tree.hpp"

namespace kusabi::wedged {

std::vector<Configuration> feasible_leaves(std::span<const PatternNode> leaves,
                                           const problems::WedgedProblem& problem,
                                           std::span<const double> friction,
                                           const conic::Tolerances& tolerances,
                                           const support::Stop& stop) {
  std::vector<Configuration> found;
  if (leaves.empty()) return found;
  SignPatternTree tree(problem, friction,
                       {.tolerances = tolerances, .precision = Precision::doubles});
  tree.end_when(stop);
  try {
    for (const auto& leaf : leaves) {
      auto decision = tree.decide(leaf);
      if (decision.leaf && decision.leaf->state == LeafState::feasible)
        found.push_back(std::move(*decision.leaf));
    }
  } catch (const support::Stopped&) {
    return found;
  }
  return found;
}

}  // namespace kusabi::wedged
