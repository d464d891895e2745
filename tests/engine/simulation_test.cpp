// Simulation tests: real workers under adverse schedules. Under any schedule every node is opened
// once, the search ends, no message is left behind, and the answer is that of one rank.
#include "engine/simulation.hpp"

#include <algorithm>

#include <boost/serialization/vector.hpp>
#include <gtest/gtest.h>

#include "support/thorough.hpp"
#include "tests/engine/queens.hpp"
#include "tests/engine/random_tree.hpp"

namespace kusabi::engine {
namespace {

using examples::Queens;
using examples::RandomTree;

template <class P>
void expect_the_same(const Outcome<P>& alone, const Simulated<P>& many, const std::string& where) {
  SCOPED_TRACE(where);
  EXPECT_EQ(many.left_behind, 0U);
  EXPECT_EQ(many.outcome.opened(), alone.opened());
  EXPECT_EQ(many.outcome.fingerprint(), alone.fingerprint());
  ASSERT_EQ(many.outcome.solutions.size(), alone.solutions.size());
  for (std::size_t i = 0; i < alone.solutions.size(); ++i) {
    EXPECT_EQ(many.outcome.solutions[i].path, alone.solutions[i].path);
  }
  std::uint64_t found = 0;
  for (const auto& rank : many.outcome.ranks) found += rank.statistics.found;
  EXPECT_EQ(found, alone.solutions.size());
}

TEST(Simulation, OutcomeIsThatOfOneRankUnderHundredsOfSchedules) {
  RandomTree tree(11, 10);
  const auto alone = search(tree);
  ASSERT_GT(alone.opened(), 100U);
  const std::vector<MachineModel> machines{
      {},                                                           // normal conditions
      {.latency = 100e-6},                                          // messages slower than nodes
      {.latency = 1e-6, .stall = 5e-3, .stall_probability = 0.02},  // ranks that stall
      {.latency = 50e-6, .node = 0},                                // nodes that cost nothing
  };
  for (std::uint64_t seed = 1; seed <= (test::thorough ? 1000 : 300); ++seed) {
    const int ranks = 1 + static_cast<int>(seed % 9);
    const auto& machine = machines[seed % machines.size()];
    Options options;
    options.nodes_per_step = seed % 3 == 0 ? 16 : 1;
    const auto many = simulate(RandomTree(11, 10), ranks, seed, machine, options);
    expect_the_same(alone, many, "seed " + std::to_string(seed));
    if (HasFailure()) break;
  }
}

TEST(Simulation, ManyRanksShareATinyTree) {
  // More ranks than nodes: all but a few are idle from the start to the end.
  Queens queens(4);
  const auto alone = search(queens);
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    expect_the_same(alone, simulate(Queens(4), 64, seed), "seed " + std::to_string(seed));
  }
}

TEST(Simulation, HundredsOfRanksHaveTheOutcomeOfOne) {
  Queens queens(8);
  const auto alone = search(queens);
  expect_the_same(alone, simulate(Queens(8), 500, 1), "500 ranks");
}

// Nodes of very different sizes, none above 4 kB; the root has hundreds. All bounds are equal.
struct Bulky {
  struct Node {
    int depth = 0;
    std::vector<char> load;
    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& depth& load;
    }
  };
  using Solution = std::vector<char>;
  Node root() const { return {}; }
  void expand(Node&& node, Expansion<Bulky>& out) {
    if (node.depth == 2) return out.solution(std::move(node.load));
    for (std::size_t child = 0; child < (node.depth == 0 ? 500 : 3); ++child) {
      out.branch({node.depth + 1, std::vector<char>(child % 7 == 0 ? 4000 : 10)});
    }
  }
  double objective(const Solution& /*solution*/) const { return 0; }
  double bound(const Node& /*node*/) const { return 0; }
};

TEST(Simulation, NoMessageExceedsTheLimit) {
  for (const auto order : {Order::depth_first, Order::best_first}) {
    Options options;
    options.order = order;
    options.message_bytes = 10'000;
    const auto simulated = simulate(Bulky{}, 4, 1, {}, options);
    EXPECT_EQ(simulated.outcome.solutions.size(), 1500U);
    // The limit covers the nodes or solutions; a trail and list headers are added.
    EXPECT_LE(simulated.largest_message, 10'000U + 500U);
    EXPECT_GT(simulated.largest_message, 5'000U);
  }
}

// Half of a large family of long nodes is sent in one transfer.
TEST(Simulation, ALargeFamilyOfLongNodesIsSentInManyMessages) {
  const auto messages_sent = [](double node) {
    const auto run = simulate(Bulky{}, 2, 1, {.node = node});
    EXPECT_EQ(run.outcome.solutions.size(), 1500U);
    const auto& first = run.outcome.ranks[0].statistics;
    return static_cast<double>(first.nodes_given) / static_cast<double>(first.transfers_sent);
  };
  EXPECT_GT(messages_sent(100e-6), 2 * messages_sent(1e-6));
}

TEST(Simulation, OutcomeIsTheSameWithOneNodePerMessage) {
  RandomTree tree(11, 12);
  const auto alone = search(tree);
  Options options;
  options.message_bytes = 1;
  expect_the_same(alone, simulate(RandomTree(11, 12), 5, 1, {}, options), "one node a message");
}

TEST(Simulation, ASeedDeterminesTheSchedule) {
  const auto once = simulate(RandomTree(11, 12), 7, 99, {.stall_probability = 0.01});
  const auto again = simulate(RandomTree(11, 12), 7, 99, {.stall_probability = 0.01});
  EXPECT_EQ(once.seconds, again.seconds);
  for (std::size_t rank = 0; rank < 7; ++rank) {
    EXPECT_EQ(once.outcome.ranks[rank].statistics.opened,
              again.outcome.ranks[rank].statistics.opened);
  }
}

// In both, a message that arrives during a node is handled after the node, and a wave that is
// complete as soon as a rank joins is handled next.
TEST(Simulation, LazySteppingGivesTheTimesOfEachStep) {
  const std::vector<MachineModel> machines{
      {},
      {.node = 10e-6, .handling = 0.5e-6},
      {.latency = 100e-6},
      {.latency = 20e-6, .machine = 3},
      {.latency = 5e-6, .node = 3e-6, .stall = 1e-3, .stall_probability = 0.01},
      {.latency = 200e-6, .stall = 2e-3, .stall_probability = 0.1},
  };
  const std::vector<Goal> goals{Goal::all, Goal::all, Goal::first};
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Options options;
    options.goal = goals[seed % goals.size()];
    options.reduction_interval = seed % 2 == 0 ? 1e-4 : 0.05;
    options.nodes_per_step = seed % 7 == 0 ? 16 : 1;
    const auto run = [&](Stepping stepping) {
      return simulate(RandomTree(seed, 12), 2 + static_cast<int>(seed % 29), seed,
                      machines[seed % machines.size()], options, 100'000'000, stepping);
    };
    const auto lazy = run(Stepping::lazy);
    const auto each = run(Stepping::each_step);
    EXPECT_EQ(lazy.seconds, each.seconds);
    for (std::size_t rank = 0; rank < lazy.outcome.ranks.size(); ++rank) {
      const auto& one = lazy.outcome.ranks[rank].statistics;
      const auto& other = each.outcome.ranks[rank].statistics;
      EXPECT_EQ(one.seconds, other.seconds) << "rank " << rank;
      EXPECT_EQ(one.idle_seconds, other.idle_seconds) << "rank " << rank;
      EXPECT_EQ(one.opened, other.opened) << "rank " << rank;
      EXPECT_EQ(one.messages_sent, other.messages_sent) << "rank " << rank;
    }
  }
}

// Virtual time does not depend on a clock, so shares and speed-up can be asserted.
TEST(Simulation, TwoRanksShareTheWorkAndHalveTheTime) {
  RandomTree tree(1, 24);
  const auto alone = search(tree);
  ASSERT_GT(alone.opened(), 10'000U);
  const auto one = simulate(RandomTree(1, 24), 1, 1);
  const auto two = simulate(RandomTree(1, 24), 2, 1);
  for (const auto& rank : two.outcome.ranks) {
    EXPECT_GE(static_cast<double>(rank.statistics.opened),
              0.25 * static_cast<double>(alone.opened()));
  }
  EXPECT_GE(one.seconds / two.seconds, 1.8);
}

TEST(Simulation, WorkReachesIdleRanksSoon) {
  // All but one of 256 ranks are asleep when a chain of a thousand nodes ends in a tree that gives
  // each of them 128 nodes of a millisecond.
  struct LateTree {
    using Node = int;
    using Solution = int;
    Node root() const { return 1014; }
    void expand(Node&& node, Expansion<LateTree>& out) {
      if (node > 0) out.branch(node - 1);
      if (node > 0 && node <= 14) out.branch(node - 1);
    }
  };
  constexpr int ranks = 256;
  const auto result = simulate(LateTree{}, ranks, 1, {.node = 1e-3});
  const double nodes = static_cast<double>(result.outcome.opened()) - 1000;
  const double ideal = nodes * 1e-3 / ranks;
  EXPECT_GT(ideal, 0.12);
  // 1.5 times the ideal time, since binary trees are shared in units of a node; random requests
  // alone take three times.
  EXPECT_LT(result.seconds - 1, 1.75 * ideal);
}

TEST(Simulation, IdleRanksSendFewRequestsToABusyRank) {
  // A path graph cannot be shared: one rank works, seven request work without success for 10 ms.
  struct Chain {
    using Node = int;
    using Solution = int;
    Node root() const { return 10'000; }
    void expand(Node&& node, Expansion<Chain>& out) {
      if (node > 0) out.branch(node - 1);
    }
  };
  const auto result = simulate(Chain{}, 8, 1);
  EXPECT_EQ(result.outcome.opened(), 10'001U);
  for (const auto& rank : result.outcome.ranks) {
    EXPECT_LE(rank.statistics.requests, 30U);  // one per millisecond, at the longest pause
  }
}

}  // namespace
}  // namespace kusabi::engine
