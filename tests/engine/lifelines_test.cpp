// Lifeline tests: registration, and the order of service.
#include "engine/detail/protocol/lifelines.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace kusabi::engine {
namespace {

TEST(Lifelines, ReachEveryRankInFewHops) {
  for (const int ranks : {1, 2, 3, 7, 64, 100}) {
    std::set<int> reached{0};
    int hops = 0;
    for (; static_cast<int>(reached.size()) < ranks; ++hops) {
      ASSERT_LT(hops, 7) << ranks << " ranks";  // log2 of 100, rounded up
      const auto before = reached;
      for (const int rank : before) {
        Lifelines lifelines(rank, ranks);
        while (const auto next = lifelines.ask_next()) reached.insert(*next);
      }
    }
  }
}

TEST(Lifelines, AreNeverTheRankItself) {
  for (int ranks = 1; ranks <= 64; ++ranks) {
    Lifelines lifelines(ranks / 2, ranks);
    while (const auto next = lifelines.ask_next()) EXPECT_NE(*next, ranks / 2) << ranks;
  }
}

TEST(Lifelines, AreRequestedOnceUntilTheyHaveServed) {
  Lifelines lifelines(0, 3);
  EXPECT_FALSE(lifelines.all_aware());
  EXPECT_EQ(lifelines.ask_next(), 1);
  EXPECT_EQ(lifelines.ask_next(), 2);
  EXPECT_EQ(lifelines.ask_next(), std::nullopt);
  EXPECT_TRUE(lifelines.asking(1));
  lifelines.refused_by(1);
  lifelines.refused_by(2);
  EXPECT_FALSE(lifelines.asking());
  EXPECT_TRUE(lifelines.all_aware());
  lifelines.served_by(2);
  EXPECT_FALSE(lifelines.all_aware());
  EXPECT_EQ(lifelines.ask_next(), 2);
  lifelines.given_by(2);
  EXPECT_EQ(lifelines.ask_next(), 2);
}

TEST(Lifelines, NodesThatArriveBeforeTheRefusalEndTheRegistration) {
  Lifelines lifelines(0, 2);
  EXPECT_EQ(lifelines.ask_next(), 1);
  lifelines.served_by(1);
  EXPECT_TRUE(lifelines.asking(1));
  lifelines.refused_by(1);
  EXPECT_FALSE(lifelines.all_aware());
  EXPECT_EQ(lifelines.ask_next(), 1);
}

// Both sides of each registration at the start agree; otherwise a rank would receive no nodes.
TEST(Lifelines, HaveRegisteredRanksThatBeginWithoutNodes) {
  for (int ranks = 1; ranks <= 33; ++ranks) {
    for (int first = 1; first <= std::min(ranks, 4); ++first) {
      std::multiset<int> registered;
      std::size_t expected = 0;
      for (int rank = 0; rank < ranks; ++rank) {
        Lifelines lifelines(rank, ranks);
        lifelines.register_idle(first, rank, ranks);
        EXPECT_EQ(lifelines.all_aware(), rank >= first || ranks == 1);
        if (rank >= first) expected += lifelines.aware();
        while (lifelines.has_registered()) registered.insert(lifelines.take());
      }
      EXPECT_EQ(registered.size(), expected);
      EXPECT_EQ(registered.count(0), 0U);
    }
  }
}

TEST(Lifelines, ServeTheLongestWaitingRankFirst) {
  Lifelines lifelines(0, 8);
  EXPECT_FALSE(lifelines.has_registered());
  lifelines.remember(5);
  lifelines.remember(3);
  EXPECT_EQ(lifelines.take(), 5);
  EXPECT_EQ(lifelines.take(), 3);
  EXPECT_FALSE(lifelines.has_registered());
}

}  // namespace
}  // namespace kusabi::engine
