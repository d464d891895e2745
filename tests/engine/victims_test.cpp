// Victims tests: choice of the rank to request work from, and the back-off.
#include "engine/detail/victims.hpp"

#include <map>

#include <gtest/gtest.h>

namespace kusabi::engine {
namespace {

TEST(Victims, AreNeverTheRankItselfAndAllOthersAlike) {
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

TEST(Victims, TheLastGiverIsAskedFirstUntilItRefuses) {
  Victims victims(0, 100, 7);
  victims.gave(42);
  EXPECT_EQ(victims.choose(), 42);
  EXPECT_EQ(victims.choose(), 42);
  victims.refused(42, 0);
  bool another = false;
  for (int draw = 0; draw < 20; ++draw) another = another || victims.choose() != 42;
  EXPECT_TRUE(another);
}

TEST(Victims, RefusalsSpaceTheRequestsOutAndATransferEndsThat) {
  Victims victims(0, 2, 7);
  EXPECT_TRUE(victims.due(0));
  double pause = 0;
  for (int refusal = 0; refusal < 4; ++refusal) {
    victims.refused(1, 0);
    EXPECT_FALSE(victims.due(0));
    EXPECT_GT(victims.next_request(), pause);
    pause = victims.next_request();
  }
  victims.gave(1);
  EXPECT_TRUE(victims.due(0));
  EXPECT_FALSE(victims.tried_ahead());
  for (int refusal = 0; refusal < 100; ++refusal) victims.refused(1, 0);
  EXPECT_TRUE(victims.tried_ahead());
  EXPECT_LE(victims.next_request(), 10e-3);  // a bounded pause: work is found soon after it appears
}

}  // namespace
}  // namespace kusabi::engine
