// Termination tests: conditions on one wave of reductions.
#include "engine/detail/protocol/termination.hpp"

#include <gtest/gtest.h>

#include "engine/detail/protocol/stamp.hpp"

namespace kusabi::engine {
namespace {

TEST(Termination, RequiresAWaveInWhichAllRanksAreQuiet) {
  EXPECT_TRUE(all_quiet({.ranks = 2, .quiet = 2, .sent = 5, .received = 5}));
  EXPECT_FALSE(all_quiet({.ranks = 2, .quiet = 1, .sent = 5, .received = 5}));
}

TEST(Termination, IsPreventedByATransferInFlight) {
  EXPECT_FALSE(all_quiet({.ranks = 2, .quiet = 2, .sent = 6, .received = 5}));
}

TEST(Termination, IsNotDetectedByACrossedWave) {
  // Rank 0 joins, receives nodes from rank 2 and gives them to rank 1, which receives them before
  // it joins: its count compensates that of rank 0, which came too late.
  EXPECT_FALSE(all_quiet({.ranks = 3, .quiet = 3, .crossed = 1, .sent = 1, .received = 1}));
}

TEST(Termination, IsDetectedFromMergedContributions) {
  Reduction wave{.ranks = 1, .quiet = 1, .sent = 1};
  wave.merge({.ranks = 1, .quiet = 1, .received = 1});
  EXPECT_TRUE(all_quiet(wave));
  wave.merge({.ranks = 1, .quiet = 1, .crossed = 1});
  EXPECT_FALSE(all_quiet(wave));
}

TEST(Stamp, LeavesTheMessageUnchanged) {
  Bytes message = stamped({'a', 'b'}, 7);
  EXPECT_EQ(take_stamp(message), 7U);
  EXPECT_EQ(message, (Bytes{'a', 'b'}));
  Bytes empty;
  EXPECT_THROW(take_stamp(empty), ContractBroken);
}

}  // namespace
}  // namespace kusabi::engine
