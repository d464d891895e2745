// One or two cone programs for each block, on the first rank.
#include "nodes/wedged/simple_leaves.hpp"

#include <cstdint>

#include <boost/serialization/vector.hpp>

#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical/critical_start.hpp"
#include "nodes/wedged/tree/decided_leaves.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

std::vector<PatternNode> tried_leaves(const problems::WedgedProblem& problem,
                                      std::span<const double> friction) {
  std::vector<PatternNode> leaves;
  const auto blocks = problems::blocks_of(problem);
  for (std::uint32_t number = 0; number < blocks.size(); ++number) {
    const int m = blocks[number].size();
    if (static_cast<std::size_t>(m) < min_candidates_for_start) continue;
    leaves.push_back({number, leaf_with(support::IndexSet::below(m), m)});
    const auto block = problems::block_problem(problem, blocks[number]);
    const std::vector<int> candidates(blocks[number].begin(), blocks[number].end());
    for (const auto& [factor, candidate] : single_contacts(block)) {
      const auto own = static_cast<std::size_t>(candidate);
      if (friction[static_cast<std::size_t>(candidates[own])] <= factor * block.friction[own])
        continue;
      leaves.push_back({number, leaf_with(support::IndexSet::single(candidate), m)});
      break;
    }
  }
  return leaves;
}

}  // namespace

std::vector<Configuration> simple_leaves(engine::Analysis& analysis,
                                         const problems::WedgedProblem& problem,
                                         std::span<const double> friction,
                                         const conic::Tolerances& tolerances) {
  return analysis.by_first_rank([&] {
    return feasible_leaves(tried_leaves(problem, friction), problem, friction, tolerances,
                           analysis.budget().stop());
  });
}

}  // namespace kusabi::wedged
