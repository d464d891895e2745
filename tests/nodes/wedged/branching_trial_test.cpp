// Sampling of branching rules compared with complete trees by each of them.
#include "nodes/wedged/tree/branching_trial.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "engine/transport/single_process.hpp"
#include "faces.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "support/thorough.hpp"

namespace kusabi::wedged {
namespace {

struct Instance {
  const char* name;
  problems::WedgedProblem problem;
  double friction;
};

std::uint64_t opened_by(Branching rule, const Instance& instance) {
  const std::vector<double> friction(instance.problem.contact_names.size(), instance.friction);
  SignPatternTree tree(instance.problem, friction, {.tolerances = {}, .branching = rule});
  return engine::search(tree).opened();
}

// Without cuts, so that the nodes are those of the rule alone.
PatternFindings found(const Instance& instance) {
  const std::vector<double> friction(instance.problem.contact_names.size(), instance.friction);
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  PatternParameters parameters;
  parameters.tree.tightening = Tightening::never;
  return find_patterns(analysis, instance.problem, friction, parameters);
}

// On each face the best of the rules takes a tenth of the nodes of the worst; the best rules
// differ.
TEST(BranchingTrial, OpensAtMostSixTimesTheNodesOfTheBestRule) {
  std::vector<Instance> instances{{"cantilever", cantilever_face(70), 5.2}};
  if (test::thorough) instances.push_back({"leaning", leaning_face(60), 0.8});
  for (const Instance& instance : instances) {
    std::vector<std::uint64_t> opened;
    for (const Branching rule : {Branching::relative, Branching::deepest, Branching::weighed})
      opened.push_back(opened_by(rule, instance));
    const auto findings = found(instance);
    EXPECT_LE(findings.outcome.opened(), 6 * std::ranges::min(opened)) << instance.name;
    EXPECT_GE(std::ranges::max(opened), 10 * std::ranges::min(opened))
        << instance.name << ": any rule would do";
  }
}

TEST(BranchingTrial, SkipsSmallBlocksAndRequestedRules) {
  const Instance small{"small", cantilever_face(39), 5.2};
  const auto findings = found(small);
  EXPECT_EQ(findings.blocks.front().branching, Branching::relative);
  EXPECT_EQ(findings.outcome.opened(), opened_by(Branching::relative, small));

  const auto problem = cantilever_face(44);
  const std::vector<double> friction(problem.contact_names.size(), 5.2);
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  EXPECT_THAT(tried_trees(analysis, problem, friction,
                          {.tolerances = {}, .branching = Branching::deepest}, 45),
              ::testing::ElementsAre(
                  ::testing::AllOf(::testing::Field(&TriedTree::branching, Branching::deepest),
                                   ::testing::Field(&TriedTree::nodes, 0))));
}

}  // namespace
}  // namespace kusabi::wedged
