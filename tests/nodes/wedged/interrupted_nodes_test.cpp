// Interruption within one node: it stays open, is not counted, and adds nothing to the answer.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "nodes/wedged/friction/critical_pattern_tree.hpp"
#include "nodes/wedged/rays/ray_list_tree.hpp"
#include "nodes/wedged/rays/ray_tree.hpp"
#include "nodes/wedged/rays/ray_trial.hpp"
#include "nodes/wedged/sweep/sweep_tree.hpp"
#include "problems/families/plane_truss.hpp"
#include "problems/wedged/precise_compliance.hpp"

namespace kusabi::wedged {
namespace {

constexpr double cell_width = 1e-8;
constexpr std::int64_t last_cell = 100'000'000;

problems::WedgedProblem truss(int rows) {
  auto problem = problems::wedged_problem(checked(problems::plane_truss({.rows = rows})));
  problem.blocks.clear();
  return problem;
}

/// A search that gets its stop request at a given poll, between nodes or within a node.
template <class Tree>
struct Interrupted {
  Interrupted(Tree& tree, std::uint64_t stop_at) {
    engine::Options options;
    options.reduction_interval = 0;
    options.interrupt = [&] {
      return ++questions >= stop_at ? engine::Interrupt::stop : engine::Interrupt::none;
    };
    outcome = engine::search(tree, options);
  }

  std::uint64_t questions = 0;
  engine::Outcome<Tree> outcome;
};

constexpr std::uint64_t never = UINT64_MAX;
/// Fewer polls belong to the search around one node.
constexpr std::uint64_t many_questions = 10;

/// @param plant returns a tree of one node
template <class Plant>
void expect_one_node_left_open(Plant plant) {
  auto whole = plant();
  const Interrupted all(whole, never);
  ASSERT_EQ(all.outcome.status, engine::Status::solved);
  ASSERT_EQ(all.outcome.opened(), 1U);
  ASSERT_GT(all.questions, many_questions);
  auto part = plant();
  const Interrupted half(part, all.questions / 2);
  EXPECT_EQ(half.outcome.status, engine::Status::interrupted);
  EXPECT_EQ(half.outcome.opened(), 0U);
  EXPECT_EQ(half.outcome.open, 1U);
  EXPECT_TRUE(half.outcome.solutions.empty());
}

PatternNode all_in_contact(int candidates) {
  return {.block = 0, .pattern = {support::IndexSet::below(candidates), {}, {}}};
}

TEST(InterruptedNodes, NewtonsMethodLeavesItsPatternOpen) {
  const auto problem = truss(8);
  expect_one_node_left_open([&] {
    return CriticalPatternTree(problem, cell_width, {{.leaf = all_in_contact(8), .feasible = true}},
                               2 * last_cell, CriticalMethod::newton, 1);
  });
}

TEST(InterruptedNodes, OfASweepBeginTheHistoryOfTheirLeafAnew) {
  const auto problem = truss(8);
  const std::vector<SweepTree::Leaf> leaves{
      {.place = all_in_contact(8), .stage = {LeafStage::Kind::solid, {}, {}}}};
  expect_one_node_left_open([&] { return SweepTree(problem, cell_width, 2 * last_cell, leaves); });
}

/// Trees of rays at a friction coefficient.
struct Given {
  Given()
      : problem(truss(8)),
        friction(8, 1.0),
        cone(problems::precise_compliance(problem), friction) {}

  [[nodiscard]] SignPatternTree tree() const { return {problem, friction}; }

  problems::WedgedProblem problem;
  std::vector<double> friction;
  rays::ReactionCone cone;
};

std::uint64_t ends(const SignPatternTally& nodes) {
  return nodes.branched + nodes.infeasible + nodes.found + nodes.flat + nodes.faces +
         nodes.marginal + nodes.undecided;
}

TEST(InterruptedNodes, OfTheTreeOfRaysAreNotCounted) {
  const Given given;
  RayTree whole(given.tree(), given.cone);
  const Interrupted all(whole, never);
  ASSERT_EQ(ends(whole.tally().patterns), all.outcome.opened());
  ASSERT_GT(all.questions, 200U);  // a walk along edges polls once in a small cone
  for (std::uint64_t stop_at = 1; stop_at < all.questions; stop_at += all.questions / 40) {
    RayTree tree(given.tree(), given.cone);
    const Interrupted part(tree, stop_at);
    EXPECT_EQ(ends(tree.tally().patterns), part.outcome.opened()) << stop_at;
    EXPECT_EQ(part.outcome.status == engine::Status::interrupted, part.outcome.open > 0) << stop_at;
  }
}

std::set<std::vector<rays::Candidates>> distinct(const engine::Outcome<RayListTree>& outcome) {
  std::set<std::vector<rays::Candidates>> all;
  for (const auto& part : outcome.solutions)
    for (const auto& zero : part.solution.rays) all.insert({zero.p, zero.q, zero.u});
  return all;
}

TEST(InterruptedNodes, OfDividedListsReportNoFalseRay) {
  const Given given;
  constexpr std::uint64_t longest = 40;
  const auto plant = [&] {
    return RayListTree(given.tree(), given.cone, rays::first_list(given.cone), longest);
  };
  auto whole = plant();
  const Interrupted all(whole, never);
  const auto known = distinct(all.outcome);
  ASSERT_GT(all.questions, 2 * all.outcome.opened());
  std::size_t stopped = 0;
  for (std::uint64_t stop_at = 1; stop_at < all.questions; stop_at += all.questions / 40) {
    auto tree = plant();
    const Interrupted part(tree, stop_at);
    if (part.outcome.status == engine::Status::interrupted) ++stopped;
    EXPECT_TRUE(std::ranges::includes(known, distinct(part.outcome))) << stop_at;
  }
  EXPECT_GT(stopped, 20U);
}

TEST(InterruptedNodes, EndATrialOfRays) {
  const Given given;
  constexpr std::uint64_t no_end = std::uint64_t{1} << 40U;
  std::uint64_t questions = 0;
  std::uint64_t stop_at = never;
  const auto trial = [&] {
    questions = 0;
    return RayTrial([&] { return given.tree(); }, given.cone,
                    [&] { return ++questions >= stop_at; });
  };
  auto whole = trial();
  ASSERT_TRUE(whole.succeeds(no_end));
  const auto all = questions;
  ASSERT_GT(all, many_questions);
  for (stop_at = 1; stop_at <= all; stop_at += 1 + all / 40) {
    auto part = trial();
    EXPECT_FALSE(part.succeeds(no_end)) << stop_at;
    EXPECT_FALSE(part.has_succeeded()) << stop_at;
  }
}

}  // namespace
}  // namespace kusabi::wedged
