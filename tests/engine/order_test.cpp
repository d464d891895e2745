// Tests of the orders depth first, best first and hybrid: equal outcomes, different opened nodes.
#include <gtest/gtest.h>

#include "engine/simulation.hpp"
#include "support/thorough.hpp"
#include "tests/engine/knapsack.hpp"
#include "tests/engine/queens.hpp"

namespace kusabi::engine {
namespace {

using examples::Knapsack;
using examples::Queens;

constexpr std::array orders{Order::depth_first, Order::best_first, Order::hybrid};

// A knapsack that records the opened nodes, in order.
class Watched {
 public:
  using Node = Knapsack::Node;
  using Solution = Knapsack::Solution;

  explicit Watched(Knapsack knapsack) : knapsack_(std::move(knapsack)) {}

  Node root() const { return knapsack_.root(); }
  void expand(Node&& node, Expansion<Watched>& out) {
    opened.push_back(node);
    knapsack_.expand(std::move(node), out);
  }
  double objective(const Solution& solution) const { return knapsack_.objective(solution); }
  double bound(const Node& node) const { return knapsack_.bound(node); }

  std::vector<Node> opened;

 private:
  Knapsack knapsack_;
};

constexpr std::size_t items = 16;

Watched watched(unsigned seed) {
  return Watched(Knapsack::random(seed, static_cast<int>(items)));
}

Options with(Order order, Goal goal = Goal::best) {
  Options options;
  options.goal = goal;
  options.order = order;
  return options;
}

TEST(Order, BestFirstOpensNodesInTheOrderOfTheirBounds) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    auto problem = watched(seed);
    search(problem, with(Order::best_first));
    for (std::size_t i = 1; i < problem.opened.size(); ++i) {
      EXPECT_LE(problem.bound(problem.opened[i - 1]), problem.bound(problem.opened[i]));
    }
  }
}

// Every node with a bound below the optimum must be opened in any order; best first alone opens
// none with a bound above it.
TEST(Order, BestFirstOpensNoNodeWithABoundAboveTheOptimum) {
  std::size_t depth_first_in_vain = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    auto problem = watched(seed);
    const auto best_first = search(problem, with(Order::best_first));
    for (const auto& node : problem.opened) EXPECT_LE(problem.bound(node), best_first.bound);

    auto other = watched(seed);
    const auto depth_first = search(other, with(Order::depth_first));
    EXPECT_EQ(depth_first.bound, best_first.bound);
    for (const auto& node : other.opened) {
      depth_first_in_vain += other.bound(node) > depth_first.bound ? 1U : 0U;
    }
  }
  EXPECT_GT(depth_first_in_vain, 10U);
}

TEST(Order, HybridDivesToALeafAndContinuesAtTheLeastBound) {
  auto problem = watched(8);
  search(problem, with(Order::hybrid));
  ASSERT_GT(problem.opened.size(), items + 2);
  for (std::size_t depth = 0; depth <= items; ++depth) {
    EXPECT_EQ(problem.opened[depth].decided, static_cast<int>(depth));
  }
  // Among the second children left by a dive, the one with the least bound comes next.
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t depth = 0; depth < items; ++depth) {
    auto left = problem.opened[depth];
    ++left.decided;  // without the item
    if (problem.opened[depth + 1].chosen != left.chosen) {
      minimum = std::min(minimum, problem.bound(left));
    }
  }
  EXPECT_EQ(problem.bound(problem.opened[items + 1]), minimum);
}

TEST(Order, BestFirstDivesIfTheHeapIsFull) {
  for (const std::size_t room : {1, 10, 100}) {
    auto problem = watched(7);
    auto options = with(Order::best_first, Goal::all);
    options.limits.nodes = 1'000'000;
    const auto free = search(problem, options);
    options.heap_nodes = room;
    const auto narrow = search(problem, options);
    EXPECT_GT(free.ranks[0].statistics.peak_open, 1000U);
    // The heap, the last bundle inserted, and the need of depth first: 2 children per level.
    EXPECT_LE(narrow.ranks[0].statistics.peak_open, room + 2 + 2 * items);
    EXPECT_EQ(narrow.opened(), free.opened());
    EXPECT_EQ(narrow.fingerprint(), free.fingerprint());
    EXPECT_EQ(narrow.solutions.size(), free.solutions.size());
  }
}

TEST(Order, TheOutcomeIsTheSameInAnyOrderOnAnyNumberOfRanks) {
  for (std::uint64_t seed = 1; seed <= (test::thorough ? 300 : 90); ++seed) {
    const auto goal = std::array{Goal::all, Goal::best, Goal::first}[seed % 3];
    const auto order = orders[seed / 3 % orders.size()];
    auto knapsack = Knapsack::random(static_cast<unsigned>(seed % 20), 12);
    const auto alone = search(knapsack, with(Order::depth_first, goal));
    auto options = with(order, goal);
    options.heap_nodes = seed % 2 == 0 ? 20 : 100'000;
    options.message_bytes = seed % 5 == 0 ? 1 : 64 * 1024;
    const MachineModel machine{.latency = seed % 7 == 0 ? 100e-6 : 2e-6};
    const auto many = simulate(knapsack, 1 + static_cast<int>(seed % 17), seed, machine, options);
    SCOPED_TRACE("seed " + std::to_string(seed));
    EXPECT_EQ(many.left_behind, 0U);
    EXPECT_EQ(many.outcome.bound, alone.bound);
    ASSERT_EQ(many.outcome.solutions.size(), alone.solutions.size());
    for (std::size_t i = 0; i < alone.solutions.size(); ++i) {
      ASSERT_EQ(many.outcome.solutions[i].path, alone.solutions[i].path);
    }
    if (goal == Goal::all) {
      EXPECT_EQ(many.outcome.fingerprint(), alone.fingerprint());
    }
  }
}

TEST(Order, RefusesProblemsWithoutBoundsOrObjective) {
  Queens queens(4);
  EXPECT_THROW(search(queens, with(Order::best_first, Goal::all)), std::invalid_argument);
  EXPECT_THROW(search(queens, with(Order::depth_first, Goal::best)), std::invalid_argument);
}

}  // namespace
}  // namespace kusabi::engine
