// The leaves sorted into blocks and counted.
#include "nodes/wedged/pattern_search.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstdio>
#include <utility>

#include "nodes/wedged/branching_trial.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

PatternFindings find_patterns(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                              std::span<const double> friction, const PatternQuestion& question) {
  SignPatternTree tree(problem, friction, question.tree);
  const auto rules = tried_branching(campaign, problem, friction, question.tree);
  for (std::size_t block = 0; block < rules.size(); ++block) tree.split_by(block, rules[block]);
  if (const char* sweeps = std::getenv("SWEEPS"); sweeps && !question.witness) {
    const auto sets = problems::blocks_of(problem);
    for (std::size_t block = 0; block < sets.size(); ++block) {
      std::vector<double> own;
      for (int i : sets[block]) own.push_back(friction[static_cast<std::size_t>(i)]);
      CandidateBounding bounding(problems::block_problem(problem, sets[block]), own, question.tree.tolerances);
      for (int k = 0; k < std::atoi(sweeps); ++k) {
        bounding.sweep();
        double sum = 0; int fixed = 0; double gaps = 0;
        for (auto& b : bounding.bounds()) { if (b.gap <= 0 || b.reaction <= 0) ++fixed; else sum += b.reaction, gaps += b.gap; }
        fprintf(stderr, "sweep %d: programs %lu fixed %d sum r %g sum u %g\n", k, bounding.programs(), fixed, sum, gaps);
      }
      tree.tighten(block, bounding.bounds());
    }
  }
  if (question.witness) tree.report_to(question.witness);
  PatternFindings findings;
  findings.outcome = campaign.search(tree, question.search);
  std::vector<Configuration> leaves;
  for (const auto& found : findings.outcome.solutions) leaves.push_back(found.solution);
  findings.leaves = maximal_cones(std::move(leaves));
  findings.tested = findings.outcome.tally().tested;
  std::ranges::sort(findings.tested, [](const auto& a, const auto& b) {
    return a.block != b.block ? a.block < b.block : comes_before(a.pattern, b.pattern);
  });
  for (const auto& candidates : problems::blocks_of(problem)) {
    findings.blocks.push_back({.candidates = candidates,
                               .branching = rules[findings.blocks.size()],
                               .cones = 0,
                               .open = 0});
  }
  for (const auto& leaf : findings.leaves) {
    auto& block = findings.blocks[leaf.block];
    switch (leaf.state) {
      case LeafState::flat:
        ++findings.flat;
        [[fallthrough]];
      case LeafState::alive:
        ++block.cones;
        break;
      case LeafState::marginal:
        ++findings.marginal;
        ++block.open;
        break;
      case LeafState::undecided:
        ++findings.undecided;
        ++block.open;
        break;
    }
  }
  return findings;
}

std::uint64_t PatternFindings::count() const {
  std::vector<std::uint64_t> cones;
  for (const auto& block : blocks) cones.push_back(block.cones);
  return combinations(cones);
}

support::IndexSet PatternFindings::idle() const {
  support::IndexSet candidates;
  if (!whole()) return candidates;
  for (const auto& block : blocks) {
    if (block.rests()) candidates |= block.candidates;
  }
  return candidates;
}

}  // namespace kusabi::wedged
