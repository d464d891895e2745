// Tests of the solutions that a search keeps: the best ones, those within a gap, those that the
// problem takes itself; both senses of an objective; bounds that a solution contradicts.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/detail/found_list.hpp"
#include "engine/nodes_along.hpp"
#include "engine/simulation.hpp"
#include "nodes/benchmark/sized_tree.hpp"
#include "tests/engine/knapsack.hpp"
#include "tests/engine/queens.hpp"
#include "tests/engine/random_tree.hpp"

namespace kusabi::engine {
namespace {

using benchmark::SizedTree;
using examples::Knapsack;
using examples::Queens;
using examples::RandomTree;
using testing::HasSubstr;

struct Numbers {
  using Solution = std::size_t;
};

TEST(FoundList, KeepsPathsAndSolutionsInOrder) {
  // Steps of one to five bytes; common, equal, longer and shorter paths.
  std::vector<Path> paths{
      {},        {0},       {0, 127, 128},     {0, 127, 16'383, 16'384}, {0, 127},
      {0, 127},  {},        {2'097'151, 5, 6}, {2'097'152, 5, 6},        {268'435'456},
      {1, 2, 3}, {1, 2, 4}, {0xFFFFFFFFU, 0},  {0xFFFFFFFFU, 0, 1}};
  FoundList<Numbers> list;
  const auto add = [&](std::size_t number) { list.push_back({paths[number], number}); };
  const auto expect_next = [&](std::size_t& number, const FoundSolution<Numbers>& found) {
    EXPECT_EQ(found.path, paths[number]);
    EXPECT_EQ(found.solution, number++);
  };
  for (std::size_t number = 0; number < 8; ++number) add(number);
  const auto position = list.position();
  for (const std::size_t number : {3U, 12U, 8U}) add(number);
  list.return_to(position);
  for (std::size_t number = 8; number < paths.size(); ++number) add(number);
  ASSERT_EQ(list.size(), paths.size());
  std::size_t seen = 0;
  list.for_each([&](const auto& found) { expect_next(seen, found); });
  EXPECT_EQ(seen, paths.size());
  for (int round = 0; round < 2; ++round) {
    std::size_t taken = 0;
    list.take_each([&](auto&& found) { expect_next(taken, found); });
    EXPECT_EQ(taken, paths.size());
    EXPECT_EQ(list.size(), 0U);
    for (std::size_t number = 0; number < paths.size(); ++number) add(number);
  }
}

Options for_the_best(const Pool& pool = {}) {
  Options options;
  options.goal = Goal::best;
  options.pool = pool;
  return options;
}

// Paths of all solutions, by enumeration: least objective first, then smallest path.
template <class P>
std::vector<Path> by_objective(P problem, const Pool& pool,
                               double cutoff = std::numeric_limits<double>::infinity()) {
  auto all = search(problem).solutions;
  std::stable_sort(all.begin(), all.end(), [&](const auto& one, const auto& other) {
    return problem.objective(one.solution) < problem.objective(other.solution);
  });
  const double minimum = problem.objective(all.front().solution);
  std::vector<Path> paths;
  for (const auto& [path, solution] : all) {
    const double above = problem.objective(solution) - minimum;
    const bool near = above <= pool.gap && !(above > pool.relative_gap * std::abs(minimum));
    if (near && problem.objective(solution) <= cutoff && paths.size() < pool.count) {
      paths.push_back(path);
    }
  }
  return paths;
}

template <class P>
std::vector<Path> paths_of(const Outcome<P>& outcome) {
  std::vector<Path> paths;
  for (const auto& found : outcome.solutions) paths.push_back(found.path);
  return paths;
}

const std::vector<Pool> pools{{.count = 3},
                              {.count = 40},
                              {.count = Pool::no_limit, .gap = 0},
                              {.count = Pool::no_limit, .gap = 2},
                              {.count = Pool::no_limit, .relative_gap = 0.03},
                              {.count = 5, .gap = 1}};

TEST(Pool, HasTheSolutionsOfBruteForce) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    auto knapsack = Knapsack::random(seed, 10);
    for (const auto& pool : pools) {
      const auto outcome = search(knapsack, for_the_best(pool));
      EXPECT_EQ(paths_of(outcome), by_objective(knapsack, pool)) << "seed " << seed;
      EXPECT_EQ(outcome.bound, knapsack.objective(outcome.solutions[0].solution));
    }
  }
}

TEST(Pool, HasTheSameSolutionsUnderAnySchedule) {
  constexpr std::array all_orders{Order::depth_first, Order::best_first, Order::hybrid};
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const SizedTree tree(seed % 10, 200, 3);
    const auto& pool = pools[seed % pools.size()];
    auto options = for_the_best(pool);
    options.order = all_orders[seed % 3];
    const MachineModel hostile{.latency = 50e-6, .stall = 1e-3, .stall_probability = 0.05};
    const int ranks = seed % 4 == 0 ? 1 : 2 << (seed % 4);
    const auto many =
        simulate(tree, ranks, seed, seed % 2 == 0 ? hostile : MachineModel{}, options);
    EXPECT_EQ(many.left_behind, 0U);
    EXPECT_EQ(paths_of(many.outcome), by_objective(tree, pool)) << "seed " << seed;
  }
}

TEST(Pool, OpensFewerNodesThanASearchForAllSolutions) {
  auto knapsack = Knapsack::random(3, 15);
  const auto all = search(knapsack).opened();
  const auto three = search(knapsack, for_the_best({.count = 3})).opened();
  const auto one = search(knapsack, for_the_best()).opened();
  EXPECT_LT(three, all / 5);
  EXPECT_GE(three, one);
}

TEST(Pool, RefusesInvalidLimits) {
  auto knapsack = Knapsack::random(1, 5);
  EXPECT_THROW(search(knapsack, for_the_best({.count = 0})), std::invalid_argument);
  EXPECT_THROW(search(knapsack, for_the_best({.gap = -1})), std::invalid_argument);
  EXPECT_THROW(search(knapsack, for_the_best({.relative_gap = 1})), std::invalid_argument);
}

TEST(Pool, ExcludesSolutionsBeyondTheCutoff) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    auto knapsack = Knapsack::random(seed, 12);
    const auto free = search(knapsack, for_the_best());
    auto options = for_the_best({.count = Pool::no_limit});
    options.cutoff = free.bound + 1;
    const auto cut = search(knapsack, options);
    EXPECT_EQ(paths_of(cut), by_objective(knapsack, options.pool, *options.cutoff));
    options = for_the_best();
    options.cutoff = free.bound;
    const auto known = search(knapsack, options);
    EXPECT_EQ(paths_of(known), paths_of(free)) << "seed " << seed;
    EXPECT_LE(known.opened(), free.opened());
    options.cutoff = free.bound - 0.5;
    const auto none = search(knapsack, options);
    EXPECT_TRUE(none.solutions.empty());
    EXPECT_EQ(none.status, Status::solved);
    EXPECT_EQ(none.bound, *options.cutoff);
  }
}

// The knapsack with a known solution, which the root reports.
struct Started : Knapsack {
  using Knapsack::Knapsack;
  explicit Started(Knapsack&& plain) : Knapsack(std::move(plain)) {}
  std::optional<Solution> known;
  void expand(Node&& node, Expansion<Started>& out) {
    if (node.decided == 0 && known) out.solution(*known);
    Knapsack::expand(std::move(node), out);
  }
};

TEST(Pool, StartsFromTheSolutionThatTheRootReports) {
  Started problem(Knapsack::random(5, 16));
  const auto free = search(problem, for_the_best());
  problem.known = free.solutions[0].solution;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto many = simulate(problem, 4, seed, {}, for_the_best()).outcome;
    ASSERT_EQ(many.solutions.size(), 1U);
    EXPECT_TRUE(many.solutions[0].path.empty());  // no other solution is better
    EXPECT_EQ(many.bound, free.bound);
  }
  EXPECT_LT(search(problem, for_the_best()).opened(), free.opened());
}

// ---- sense ----------------------------------------------------------------------------------

// The knapsack with its value as the objective.
struct Valuable : Knapsack {
  explicit Valuable(Knapsack&& plain) : Knapsack(std::move(plain)) {}
  static constexpr bool maximises = true;
  double objective(const Solution& solution) const { return solution.value; }
  double bound(const Node& node) const { return -Knapsack::bound(node); }
  void expand(Node&& node, Expansion<Valuable>& out) {
    min_cutoff = std::min(min_cutoff, out.cutoff());
    excluded += out.ruled_out(0) ? 1 : 0;
    possible += out.ruled_out(1e9) ? 0 : 1;
    Knapsack::expand(std::move(node), out);
  }
  double min_cutoff = 0;
  int excluded = 0;
  int possible = 0;
};

TEST(Maximisation, EqualsMinimisationOfTheNegativeObjective) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    auto knapsack = Knapsack::random(seed, 12);
    Valuable valuable(Knapsack::random(seed, 12));
    for (const auto& pool : pools) {
      const auto minimum = search(knapsack, for_the_best(pool));
      const auto maximum = simulate(valuable, 3, seed, {}, for_the_best(pool)).outcome;
      EXPECT_EQ(paths_of(maximum), paths_of(minimum)) << "seed " << seed;
      EXPECT_EQ(maximum.bound, -minimum.bound);
    }
  }
}

TEST(Maximisation, HasCutoffBoundAndProgressInTheSenseOfTheProblem) {
  Valuable valuable(Knapsack::random(3, 18));
  auto options = for_the_best();
  options.reduction_interval = 0;
  options.nodes_per_step = 1;
  double objective = 0;
  double bound = 0;
  options.progress = [&](const Progress& progress) {
    if (progress.open == 0) return;
    objective = progress.objective;
    bound = progress.bound;
    EXPECT_TRUE(std::isinf(objective) ? objective < 0 : objective > 0) << objective;
    EXPECT_GT(bound, 0);
  };
  const auto outcome = search(valuable, options);
  EXPECT_EQ(objective, outcome.bound);
  EXPECT_EQ(valuable.min_cutoff, -std::numeric_limits<double>::infinity());
  EXPECT_GT(valuable.excluded, 0);
  EXPECT_EQ(static_cast<std::uint64_t>(valuable.possible), outcome.opened());
  options.cutoff = outcome.bound + 1;
  options.progress = {};
  EXPECT_TRUE(search(valuable, options).solutions.empty());
}

// ---- bounds -----------------------------------------------------------------------------------

// A bound with the sign of the value, not of the objective; or another error.
struct Misjudged : Knapsack {
  Misjudged(Knapsack&& plain, double factor) : Knapsack(std::move(plain)), factor_(factor) {}
  double bound(const Node& node) const { return factor_ * Knapsack::bound(node); }
  void expand(Node&& node, Expansion<Misjudged>& out) { Knapsack::expand(std::move(node), out); }

 private:
  double factor_;
};

std::string error_of(double factor, const Options& options) {
  Misjudged problem(Knapsack::random(1, 10), factor);
  try {
    search(problem, options);
  } catch (const ExpansionFailed& error) {
    return error.what();
  }
  return "none";
}

TEST(Bound, OfTheWrongSignIsAnErrorAtTheFirstSolution) {
  const auto line = error_of(-1, for_the_best());
  EXPECT_THAT(line,
              testing::MatchesRegex("node [0-9.]+: the bound ([0-9]+) of this node is greater "
                                    "than the objective -[0-9]+ of its solution; expected a "
                                    "lower bound .*"));
}

TEST(Bound, ExcessWithinTheToleranceIsAccepted) {
  EXPECT_EQ(error_of(1 - 1e-9, for_the_best()), "none");
  EXPECT_THAT(error_of(1 - 1e-3, for_the_best()), HasSubstr("of this node is greater than"));
  auto options = for_the_best();
  options.bound_tolerance = 1e-2;
  EXPECT_EQ(error_of(1 - 1e-3, options), "none");
}

TEST(Bound, IsNotCheckedIfAllSolutionsAreSought) {
  EXPECT_EQ(error_of(-1, {}), "none");
}

struct Overvalued : Knapsack {
  explicit Overvalued(Knapsack&& plain) : Knapsack(std::move(plain)) {}
  static constexpr bool maximises = true;
  double objective(const Solution& solution) const { return solution.value; }
  void expand(Node&& node, Expansion<Overvalued>& out) { Knapsack::expand(std::move(node), out); }
};

TEST(Bound, OfAMaximumIsAnUpperBound) {
  Overvalued problem(Knapsack::random(1, 10));  // its bound is that of the minimum
  try {
    search(problem, for_the_best());
    FAIL();
  } catch (const ExpansionFailed& error) {
    EXPECT_THAT(error.what(), HasSubstr("is less than the objective"));
    EXPECT_THAT(error.what(), HasSubstr("expected an upper bound"));
  }
}

// Counts the calls of `bound` of all copies.
struct BoundCounter : SizedTree {
  BoundCounter(std::uint64_t seed, std::uint64_t size) : SizedTree(seed, size, 500) {}
  double bound(const Node& node) const {
    ++*calls;
    return SizedTree::bound(node);
  }
  std::shared_ptr<std::uint64_t> calls = std::make_shared<std::uint64_t>(0);
};

TEST(Bound, OfANodeIsComputedOnce) {
  constexpr std::array all_orders{Order::depth_first, Order::best_first, Order::hybrid};
  for (const auto order : all_orders) {
    BoundCounter tree(4, 5'000);
    auto options = for_the_best();
    options.order = order;
    options.nodes_per_step = 1;
    options.reduction_interval = 0;  // a reduction looks at all open nodes
    const auto total = search(tree, options).total();
    EXPECT_LE(*tree.calls, total.opened + total.pruned);
    EXPECT_GT(total.opened, 200U);
  }
}

// ---- solutions that the problem takes itself --------------------------------------------------

using Taken = std::vector<std::pair<Path, std::uint64_t>>;

struct Emitter : RandomTree {
  using RandomTree::RandomTree;
  void expand(Node&& node, Expansion<Emitter>& out) { RandomTree::grow(std::move(node), out); }
  bool emit(const Path& path, Solution& solution) {
    if (left == solution) return false;
    taken->emplace_back(path, solution);
    return true;
  }
  std::shared_ptr<Taken> taken = std::make_shared<Taken>();
  std::optional<std::uint64_t> left;  // a solution that is left to the engine
};

template <class P>
Taken pairs(const std::vector<FoundSolution<P>>& solutions) {
  Taken list;
  for (const auto& [path, solution] : solutions) list.emplace_back(path, solution);
  return list;
}

TEST(Emission, PassesEachSolutionOnceAndKeepsNone) {
  RandomTree plain(3, 12);
  const auto kept = search(plain).solutions;
  for (const double share : {0.0, 1.0}) {
    Emitter emitter(3, 12);
    Options options;
    options.check_expand = share;
    const auto outcome = simulate(emitter, 5, 1, {}, options).outcome;
    EXPECT_TRUE(outcome.solutions.empty());
    EXPECT_EQ(outcome.total().found, kept.size());
    std::sort(emitter.taken->begin(), emitter.taken->end());
    EXPECT_EQ(*emitter.taken, pairs(kept));
  }
}

TEST(Emission, LeavesRefusedSolutionsToTheEngine) {
  RandomTree plain(3, 12);
  const auto all = pairs(search(plain).solutions);
  Emitter emitter(3, 12);
  emitter.left = all[all.size() / 2].second;
  const auto outcome = simulate(emitter, 5, 1, {}, {}).outcome;
  Taken kept, taken;
  for (const auto& each : all) (each.second == emitter.left ? kept : taken).push_back(each);
  EXPECT_EQ(outcome.total().found, all.size());
  EXPECT_EQ(pairs(outcome.solutions), kept);
  std::sort(emitter.taken->begin(), emitter.taken->end());
  EXPECT_EQ(*emitter.taken, taken);
}

TEST(Emission, CountsTowardsTheSolutionLimit) {
  Emitter emitter(3, 20);
  Options options;
  options.limits.solutions = 10;
  options.reduction_interval = 0;
  options.nodes_per_step = 1;
  const auto outcome = search(emitter, options);
  EXPECT_EQ(outcome.status, Status::solution_limit);
  EXPECT_EQ(emitter.taken->size(), 10U);
}

// ---- nodes along a path -----------------------------------------------------------------------

TEST(NodesAlong, LeadFromTheRootToTheSolution) {
  Queens queens(6);
  const auto outcome = search(queens);
  ASSERT_EQ(outcome.solutions.size(), 4U);
  for (const auto& found : outcome.solutions) {
    const auto nodes = nodes_along(queens, found);
    ASSERT_EQ(nodes.size(), 7U);
    EXPECT_TRUE(nodes.front().columns.empty());
    for (std::size_t row = 0; row < nodes.size(); ++row) {
      const auto& columns = found.solution.columns;
      EXPECT_TRUE(
          std::equal(nodes[row].columns.begin(), nodes[row].columns.end(), columns.begin()));
      EXPECT_EQ(nodes[row].columns.size(), row);
    }
  }
}

TEST(NodesAlong, OfAnotherPathAreRefused) {
  Queens queens(6);
  auto solutions = search(queens).solutions;
  std::swap(solutions[0].path, solutions[1].path);
  EXPECT_THROW(nodes_along(queens, solutions[0]), std::invalid_argument);
  solutions[0].path = {0, 99};
  EXPECT_THROW(nodes_along(queens, solutions[0]), std::invalid_argument);
}

// ---- memory -----------------------------------------------------------------------------------

TEST(HeapBytes, LimitTheMemoryByDiving) {
  constexpr std::size_t some = 5'000;
  SizedTree tree(7, 20'000, 5);
  auto options = for_the_best({.count = Pool::no_limit});
  options.order = Order::best_first;
  const auto free = search(tree, options);
  options.heap_bytes = some;
  const auto limited = search(tree, options);
  EXPECT_EQ(paths_of(limited), paths_of(free));
  EXPECT_GT(free.total().peak_open, 1000U);
  EXPECT_LT(limited.total().peak_open, free.total().peak_open / 4);
}

}  // namespace
}  // namespace kusabi::engine
