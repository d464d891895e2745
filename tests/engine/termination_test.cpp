// Termination tests of Mattern's four-counter method.
#include "engine/detail/termination.hpp"

#include <gtest/gtest.h>

namespace kusabi::engine {
namespace {

Reduction wave(std::uint64_t idle, std::uint64_t sent, std::uint64_t received) {
  return {.ranks = 2, .idle = idle, .sent = sent, .received = received};
}

TEST(Termination, NeedsTwoQuietWaves) {
  Termination termination;
  EXPECT_FALSE(termination.observe(wave(2, 5, 5)));
  EXPECT_TRUE(termination.observe(wave(2, 5, 5)));
}

TEST(Termination, ABusyRankKeepsTheSearchFeasible) {
  Termination termination;
  EXPECT_FALSE(termination.observe(wave(1, 5, 5)));
  EXPECT_FALSE(termination.observe(wave(1, 5, 5)));
}

TEST(Termination, ATransferInFlightKeepsTheSearchFeasible) {
  Termination termination;
  EXPECT_FALSE(termination.observe(wave(2, 6, 5)));
  EXPECT_FALSE(termination.observe(wave(2, 6, 5)));
}

TEST(Termination, WorkThatMovedBetweenTheWavesKeepsTheSearchFeasible) {
  // A transfer crossed the first wave: both waves are idle and balanced, but the sums differ.
  Termination termination;
  EXPECT_FALSE(termination.observe(wave(2, 5, 5)));
  EXPECT_FALSE(termination.observe(wave(2, 6, 6)));
  EXPECT_TRUE(termination.observe(wave(2, 6, 6)));
}

TEST(Termination, AQuietWaveDoesNotCountAfterABusyOne) {
  Termination termination;
  EXPECT_FALSE(termination.observe(wave(2, 5, 5)));
  EXPECT_FALSE(termination.observe(wave(1, 5, 5)));
  EXPECT_FALSE(termination.observe(wave(2, 5, 5)));
}

}  // namespace
}  // namespace kusabi::engine
