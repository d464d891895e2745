// Tests of Goal::best and Goal::first: the answer equals that of brute force, is the same on any
// number of ranks, and is found without opening the whole tree.
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "engine/detail/incumbent.hpp"
#include "engine/detail/protocol/relay.hpp"
#include "engine/simulation.hpp"
#include "tests/engine/knapsack.hpp"
#include "tests/engine/queens.hpp"
#include "tests/engine/random_tree.hpp"

namespace kusabi::engine {
namespace {

using examples::Knapsack;
using examples::Queens;
using examples::RandomTree;

Options with_goal(Goal goal) {
  Options options;
  options.goal = goal;
  return options;
}

// The best of all solutions, by enumeration: least objective, then smallest path.
FoundSolution<Knapsack> best_of_all(Knapsack knapsack) {
  const auto all = search(knapsack).solutions;
  auto best = all.front();
  for (const auto& each : all) {
    if (knapsack.objective(each.solution) < knapsack.objective(best.solution)) best = each;
  }
  return best;
}

TEST(Goal, TheBestIsThatOfBruteForce) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    auto knapsack = Knapsack::random(seed, 12);
    const auto expected = best_of_all(knapsack);
    const auto outcome = search(knapsack, with_goal(Goal::best));
    ASSERT_EQ(outcome.solutions.size(), 1U);
    EXPECT_EQ(outcome.solutions[0].path, expected.path) << "seed " << seed;
    EXPECT_EQ(outcome.status, Status::solved);
    EXPECT_EQ(outcome.bound, knapsack.objective(expected.solution));
  }
}

TEST(Goal, TheBestIsTheSameOnAnyNumberOfRanksUnderAnySchedule) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    auto knapsack = Knapsack::random(static_cast<unsigned>(seed % 20), 14);
    const auto alone = search(knapsack, with_goal(Goal::best));
    const auto many = simulate(knapsack, 2 + static_cast<int>(seed % 40), seed,
                               {.latency = seed % 2 == 0 ? 1e-6 : 50e-6}, with_goal(Goal::best));
    EXPECT_EQ(many.left_behind, 0U);
    ASSERT_EQ(many.outcome.solutions.size(), 1U) << "seed " << seed;
    EXPECT_EQ(many.outcome.solutions[0].path, alone.solutions[0].path) << "seed " << seed;
    EXPECT_EQ(many.outcome.bound, alone.bound);
  }
}

TEST(Goal, BestOpensASmallPartOfTheTreeWithABound) {
  auto knapsack = Knapsack::random(3, 18);
  const auto all = search(knapsack);
  const auto best = search(knapsack, with_goal(Goal::best));
  EXPECT_LT(best.opened(), all.opened() / 10);
  EXPECT_GT(best.ranks[0].statistics.pruned, 0U);
}

TEST(Goal, TheFirstIsTheFirstInDepthFirstOrder) {
  Queens queens(8);
  const auto all = search(queens);
  const auto first = search(queens, with_goal(Goal::first));
  ASSERT_EQ(first.solutions.size(), 1U);
  EXPECT_EQ(first.solutions[0].path, all.solutions[0].path);
  EXPECT_LT(first.opened(), all.opened() / 10);
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto many = simulate(Queens(8), 13, seed, {}, with_goal(Goal::first));
    ASSERT_EQ(many.outcome.solutions.size(), 1U);
    EXPECT_EQ(many.outcome.solutions[0].path, all.solutions[0].path) << "seed " << seed;
  }
}

TEST(Goal, ATreeWithoutSolutionsIsSolved) {
  Queens queens(3);
  const auto outcome = search(queens, with_goal(Goal::first));
  EXPECT_TRUE(outcome.solutions.empty());
  EXPECT_EQ(outcome.status, Status::solved);
}

struct NotANumber {
  using Node = int;
  using Solution = int;
  Node root() const { return 0; }
  void expand(Node&& /*node*/, Expansion<NotANumber>& out) { out.solution(1); }
  double objective(const Solution& /*solution*/) const { return std::nan(""); }
};

TEST(Goal, AnObjectiveThatIsNotANumberIsAnError) {
  NotANumber problem;
  EXPECT_THROW(search(problem, with_goal(Goal::best)), ExpansionFailed);
}

TEST(Incumbent, PrefersTheSmallerObjectiveThenTheSmallerPath) {
  const Incumbent none;
  const Incumbent low{true, 1, {5}};
  const Incumbent high{true, 2, {0}};
  const Incumbent left{true, 1, {4, 9}};
  EXPECT_TRUE(low.better_than(none));
  EXPECT_FALSE(none.better_than(low));
  EXPECT_TRUE(low.better_than(high));
  EXPECT_TRUE(left.better_than(low));
  EXPECT_FALSE(low.better_than(low));
}

TEST(Incumbent, RulesOutOnlyNodesWithoutABetterSolution) {
  const Incumbent best{true, 1, {2, 1}};
  EXPECT_TRUE(best.rules_out(1.5, {0}));    // worse, at any path
  EXPECT_FALSE(best.rules_out(1, {2, 0}));  // equal, with a smaller path
  // above the incumbent: a descendant may have a smaller path
  EXPECT_FALSE(best.rules_out(1, {2}));
  EXPECT_TRUE(best.rules_out(1, {2, 1, 0}));  // below the incumbent: greater path
  EXPECT_TRUE(best.rules_out(1, {3}));        // greater path
  EXPECT_FALSE(best.rules_out(0.5, {3}));     // may be better
  // The node of the incumbent: no further equal solution can have a smaller path.
  EXPECT_FALSE(best.rules_out(1, {2, 1}));
  EXPECT_TRUE(best.rules_out_more(1, {2, 1}));
  EXPECT_FALSE(best.rules_out_more(1, {2, 0}));
  EXPECT_THROW(static_cast<void>(best.rules_out(std::nan(""), {3})), std::domain_error);
}

TEST(RelayNeighbours, AreMutualAndReachEveryRank) {
  for (const int ranks : {1, 2, 17, 18, 300}) {
    std::vector<int> reached{0};
    std::vector<bool> seen(static_cast<std::size_t>(ranks), false);
    seen[0] = true;
    for (std::size_t at = 0; at < reached.size(); ++at) {
      for (const int next : relay_neighbours(reached[at], ranks)) {
        const auto back = relay_neighbours(next, ranks);
        EXPECT_NE(std::find(back.begin(), back.end(), reached[at]), back.end());
        if (!seen[static_cast<std::size_t>(next)]) reached.push_back(next);
        seen[static_cast<std::size_t>(next)] = true;
      }
    }
    EXPECT_EQ(reached.size(), static_cast<std::size_t>(ranks));
  }
}

TEST(Limits, NodeLimitStopsTheSearchWithOpenNodes) {
  RandomTree tree(1, 24);
  Options options;
  options.limits.nodes = 1000;
  const auto outcome = search(tree, options);
  EXPECT_EQ(outcome.status, Status::node_limit);
  EXPECT_EQ(outcome.opened(), 1000U);
  EXPECT_GT(outcome.open, 0U);
}

// A slow reduction (a rank has no core) must not let the others finish the tree.
TEST(Limits, NodeLimitStopsTheSearchWithSlowReductions) {
  RandomTree tree(11, 10);
  const auto whole = search(tree).opened();
  Options options;
  options.limits.nodes = whole / 4;
  const MachineModel late{.latency = 5e-3, .node = 1e-7, .stall = 20e-3, .stall_probability = 0.3};
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto many = simulate(RandomTree(11, 10), 3, seed, late, options);
    EXPECT_EQ(many.outcome.status, Status::node_limit) << seed;
    EXPECT_LT(many.outcome.opened(), whole) << seed;
  }
}

TEST(Limits, SolutionLimitStopsAllRanks) {
  Options options;
  options.limits.solutions = 10;
  options.reduction_interval = 20e-6;
  const auto outcome = simulate(RandomTree(1, 24), 5, 3, {}, options).outcome;
  EXPECT_EQ(outcome.status, Status::solution_limit);
  EXPECT_GE(outcome.solutions.size(), 10U);
  EXPECT_GT(outcome.open, 0U);
}

TEST(Limits, TimeLimitStopsInVirtualTime) {
  Options options;
  options.limits.seconds = 5e-3;
  options.reduction_interval = 1e-3;
  const auto simulated = simulate(RandomTree(1, 24), 2, 3, {}, options);
  EXPECT_EQ(simulated.outcome.status, Status::time_limit);
  EXPECT_GE(simulated.seconds, 5e-3);
  EXPECT_LT(simulated.seconds, 10e-3);
  EXPECT_EQ(simulated.left_behind, 0U);
}

// A reduction does not include nodes in flight, and one of them may have the least bound: with slow
// messages and few nodes on each rank this happens now and then.
TEST(Limits, GapLimitStopsWithAValidBoundWithinTheGap) {
  constexpr double gap = 0.005;
  int stopped = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    auto knapsack = Knapsack::random(static_cast<unsigned>(seed % 60), 20);
    const double best = search(knapsack, with_goal(Goal::best)).bound;
    Options options = with_goal(Goal::best);
    options.order = seed % 2 == 0 ? Order::depth_first : Order::best_first;
    options.limits.gap = gap;
    options.reduction_interval = 5e-6;
    const MachineModel machine{.latency = seed % 3 == 0 ? 2e-6 : 100e-6};
    const int ranks = 2 + static_cast<int>(seed % 7);
    const auto outcome = simulate(knapsack, ranks, seed, machine, options).outcome;
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_EQ(outcome.solutions.size(), 1U);
    const double objective = knapsack.objective(outcome.solutions[0].solution);
    EXPECT_LE(outcome.bound, best);
    EXPECT_GE(objective, best);
    EXPECT_LE(objective - outcome.bound, gap * std::abs(objective));
    if (outcome.status == Status::gap_limit) ++stopped;
  }
  EXPECT_GT(stopped, 30);
}

TEST(Limits, AnInterruptOnOneRankStopsAll) {
  Options options;
  options.reduction_interval = 20e-6;
  int asked = 0;
  options.interrupt = [&] { return ++asked > 20 ? Interrupt::stop : Interrupt::none; };
  const auto simulated = simulate(RandomTree(1, 24), 4, 3, {}, options);
  EXPECT_EQ(simulated.outcome.status, Status::interrupted);
  EXPECT_EQ(simulated.left_behind, 0U);
}

}  // namespace
}  // namespace kusabi::engine
