// PairedTurns and quartiles, with turns whose CPU times are given.
#include "run/bench/paired_turns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kusabi::run {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(PairedTurns, ARatioIsTheTimeOfANodeInTheRecursionByThatInTheSearch) {
  PairedTurns turns(0.025);
  turns.add_recursion({0.05, 1000});
  turns.add_search({0.05, 800});
  turns.add_recursion({0.04, 400});
  turns.add_search({0.08, 800});
  EXPECT_THAT(turns.ratios(), ElementsAre(DoubleEq(0.8), DoubleEq(1)));
  EXPECT_DOUBLE_EQ(turns.search_seconds(), 0.13);
}

TEST(PairedTurns, APairWaitsUntilBothHalvesAreLongEnough) {
  PairedTurns turns(0.025);
  turns.add_recursion({0.05, 100});
  turns.add_search({0.01, 10});
  turns.add_recursion({0.05, 100});
  turns.add_search({0.04, 90});
  EXPECT_THAT(turns.ratios(), ElementsAre(DoubleEq(1)));
}

TEST(PairedTurns, TheRestCountsOnlyWithoutAPair) {
  PairedTurns turns(0.025);
  turns.add_recursion({0.001, 20});
  turns.add_search({0.002, 20});
  EXPECT_THAT(turns.ratios(), ElementsAre(DoubleEq(0.5)));
  turns.add_recursion({0.099, 980});
  turns.add_search({0.098, 980});
  turns.add_recursion({0.001, 20});
  turns.add_search({0.002, 20});
  EXPECT_THAT(turns.ratios(), ElementsAre(DoubleEq(1)));
}

TEST(PairedTurns, ATurnOfTheSearchWithoutNodesHasTheRatioZero) {
  PairedTurns turns(0.025);
  turns.add_recursion({0.05, 100});
  turns.add_search({0.05, 0});
  EXPECT_THAT(turns.ratios(), ElementsAre(0));
}

TEST(PairedTurns, HasNoRatioIfOneOfBothHadNoTurn) {
  PairedTurns turns(0.025);
  EXPECT_THAT(turns.ratios(), IsEmpty());
  turns.add_search({0.05, 100});
  EXPECT_THAT(turns.ratios(), IsEmpty());
}

TEST(Quartiles, InterpolateBetweenSortedValues) {
  const auto [lower, median, upper] = quartiles({4, 1, 3, 2, 5});
  EXPECT_DOUBLE_EQ(lower, 2);
  EXPECT_DOUBLE_EQ(median, 3);
  EXPECT_DOUBLE_EQ(upper, 4);
  EXPECT_DOUBLE_EQ(quartiles({1, 2}).lower, 1.25);
  EXPECT_DOUBLE_EQ(quartiles({7}).upper, 7);
}

}  // namespace
}  // namespace kusabi::run
