// Victims tests: choice of the rank to request work from, and the back-off.
#include "engine/detail/protocol/victims.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace kusabi::engine {
namespace {

TEST(Victims, AreAllOtherRanksWithEqualProbability) {
  constexpr int ranks = 8;
  constexpr int self = 3;
  constexpr int expected = 10'000;
  constexpr int draws = 7 * expected;
  Victims victims(self, ranks, 1);
  std::map<int, int> count;
  for (int draw = 0; draw < draws; ++draw) {
    const int victim = victims.choose();
    ++count[victim];
    victims.refused(victim, 0);
  }
  EXPECT_EQ(count.count(self), 0U);
  EXPECT_EQ(count.size(), 7U);
  for (const auto& [victim, times] : count) {
    EXPECT_NEAR(times, expected, 500) << "victim " << victim;  // five standard deviations
  }
}

// Neighbours are mutual, few and never the rank itself, and lead from each rank to every other.
TEST(Victims, NeighboursFormAConnectedGraphOfAllRanks) {
  for (const int ranks : {2, 3, 33, 34, 35, 64, 1000}) {
    SCOPED_TRACE(ranks);
    std::vector<std::set<int>> graph;
    for (int rank = 0; rank < ranks; ++rank) {
      const Victims victims(rank, ranks, 5);
      graph.emplace_back(victims.neighbours().begin(), victims.neighbours().end());
      ASSERT_EQ(graph.back().count(rank), 0U);
      ASSERT_GE(graph.back().size(), static_cast<std::size_t>(std::min(ranks - 1, 32)));
      ASSERT_LE(graph.back().size(), 33U);
    }
    std::vector<int> reached{0};
    std::set<int> seen{0};
    for (std::size_t next = 0; next < reached.size(); ++next) {
      for (const int other : graph[static_cast<std::size_t>(reached[next])]) {
        ASSERT_EQ(graph[static_cast<std::size_t>(other)].count(reached[next]), 1U);
        if (seen.insert(other).second) reached.push_back(other);
      }
    }
    EXPECT_EQ(reached.size(), static_cast<std::size_t>(ranks));
  }
}

TEST(Victims, AreOfTheOwnMachineUntilOneRefuses) {
  const std::set<int> machine{4, 5, 7};
  Victims victims(6, 10'000, 5, {machine.begin(), machine.end()});
  const auto neighbours = victims.neighbours();
  for (int draw = 0; draw < 100; ++draw) EXPECT_EQ(machine.count(victims.choose()), 1U);
  victims.refused(4, 0);
  for (int draw = 0; draw < 100; ++draw) {
    EXPECT_TRUE(std::binary_search(neighbours.begin(), neighbours.end(), victims.choose()));
  }
  victims.sent(7);
  EXPECT_EQ(victims.choose(), 7);
  victims.refused(7, 0);
  for (int draw = 0; draw < 100; ++draw) EXPECT_EQ(machine.count(victims.choose()), 1U);
  victims.refused(4, 0);
  for (int draw = 0; draw < 100; ++draw) {
    EXPECT_TRUE(std::binary_search(neighbours.begin(), neighbours.end(), victims.choose()));
  }
}

TEST(Victims, AreOfTheOwnMachineAfterTheFirstTransferOfARankWithoutNodes) {
  Victims victims(6, 10'000, 5, {4, 5});
  victims.give_up();
  victims.sent(4711);
  victims.refused(4711, 0);
  for (int draw = 0; draw < 100; ++draw) EXPECT_EQ(victims.choose() / 2, 2);
}

TEST(Victims, TheLastGiverIsAskedFirstUntilItRefuses) {
  Victims victims(0, 100, 7);
  victims.sent(42);
  EXPECT_EQ(victims.choose(), 42);
  EXPECT_EQ(victims.choose(), 42);
  victims.refused(42, 0);
  bool another = false;
  for (int draw = 0; draw < 20; ++draw) another = another || victims.choose() != 42;
  EXPECT_TRUE(another);
}

TEST(Victims, RefusalsDelayRequestsUntilATransferArrives) {
  Victims victims(0, 2, 7);
  EXPECT_TRUE(victims.due(0));
  double pause = 0;
  for (int refusal = 0; refusal < 4; ++refusal) {
    victims.refused(1, 0);
    EXPECT_FALSE(victims.due(0));
    EXPECT_GT(victims.next_request(), pause);
    pause = victims.next_request();
  }
  victims.sent(1);
  EXPECT_TRUE(victims.due(0));
  EXPECT_FALSE(victims.has_requested_early());
  for (int refusal = 0; refusal < 100; ++refusal) victims.refused(1, 0);
  EXPECT_TRUE(victims.has_requested_early());
  EXPECT_LE(victims.next_request(), 10e-3);  // a bounded pause: work is found soon after it appears
}

}  // namespace
}  // namespace kusabi::engine
