// Lifeline tests: registration, and the order of service.
#include "engine/detail/lifelines.hpp"

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
        while (const auto next = lifelines.next()) {
          reached.insert(*next);
          lifelines.left_name_with(*next);
        }
      }
    }
  }
}

TEST(Lifelines, AreNeverTheRankItself) {
  for (int ranks = 1; ranks <= 64; ++ranks) {
    Lifelines lifelines(ranks / 2, ranks);
    while (const auto next = lifelines.next()) {
      EXPECT_NE(*next, ranks / 2) << ranks << " ranks";
      lifelines.left_name_with(*next);
    }
  }
}

TEST(Lifelines, ANameIsLeftOnceUntilItWasServed) {
  Lifelines lifelines(0, 3);
  lifelines.left_name_with(1);
  lifelines.left_name_with(2);
  EXPECT_EQ(lifelines.next(), std::nullopt);
  lifelines.served_by(2);
  EXPECT_EQ(lifelines.next(), 2);
}

TEST(Lifelines, WhoWaitedLongestIsServedFirst) {
  Lifelines lifelines(0, 8);
  EXPECT_FALSE(lifelines.wanted());
  lifelines.remember(5);
  lifelines.remember(3);
  EXPECT_EQ(lifelines.take(), 5);
  EXPECT_EQ(lifelines.take(), 3);
  EXPECT_FALSE(lifelines.wanted());
}

}  // namespace
}  // namespace kusabi::engine
