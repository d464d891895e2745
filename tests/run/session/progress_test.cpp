// Progress of a search: the estimated remaining time, and the format of numbers.
#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/session/progress_text.hpp"

namespace kusabi::run {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- remaining time
// -------------------------------------------------------------------------------

TEST(RemainingTime, OfASteadySearchIsExact) {
  RemainingTime time;
  for (int i = 0; i <= 300; ++i) time.observe(0.1 * i, 0.001 * i);  // 1 % per second
  ASSERT_TRUE(time.seconds());
  EXPECT_NEAR(*time.seconds(), 70, 1e-6);  // rounding only
}

TEST(RemainingTime, IsUnknownInAnEarlyOrUnevenSearch) {
  RemainingTime nothing;
  EXPECT_FALSE(nothing.seconds());

  RemainingTime early;  // fast, but less than a second
  for (int i = 0; i <= 19; ++i) early.observe(0.05 * i, 0.01 * i);
  EXPECT_FALSE(early.seconds());
  early.observe(1.01, 0.2);
  EXPECT_TRUE(early.seconds());

  RemainingTime little;  // less than half a percent closed
  for (int i = 0; i <= 100; ++i) little.observe(i, 0.00004 * i);
  EXPECT_FALSE(little.seconds());

  RemainingTime rare;  // half of the tree closed at once
  for (int i = 0; i <= 100; ++i) rare.observe(i, i < 50 ? 0 : 0.5);
  EXPECT_FALSE(rare.seconds());
}

TEST(RemainingTime, AfterARestartCountsThisRunOnly) {
  RemainingTime time;
  for (int i = 0; i <= 100; ++i) time.observe(0.1 * i, 0.5 + 0.001 * i);
  ASSERT_TRUE(time.seconds());
  EXPECT_NEAR(*time.seconds(), 40, 1e-6);
}

TEST(RemainingTime, FollowsAChangeOfPace) {
  RemainingTime time;
  for (int i = 0; i <= 1000; ++i) time.observe(0.1 * i, 0.0002 * i);  // 100 s at 0.2 % per second
  for (int i = 1; i <= 600; ++i) time.observe(100 + 0.1 * i, 0.2 + 0.001 * i);  // then 60 s at 1 %
  // The mean rate of the whole run would give 32 s, the recent rate 20 s.
  ASSERT_TRUE(time.seconds());
  EXPECT_GT(*time.seconds(), 20);
  EXPECT_LT(*time.seconds(), 24);
}

TEST(RemainingTime, DoesNotDependOnTheNumberOfObservations) {
  RemainingTime often;
  RemainingTime seldom;
  for (int i = 0; i <= 10'000; ++i) often.observe(0.01 * i, 0.00005 * i);
  for (int i = 0; i <= 50; ++i) seldom.observe(2.0 * i, 0.01 * i);
  ASSERT_TRUE(often.seconds() && seldom.seconds());
  EXPECT_NEAR(*often.seconds(), *seldom.seconds(), 1e-6);
}

TEST(RemainingTime, IsNeverNegativeWhenSharesDoNotAddUpToOne) {
  RemainingTime time;
  for (int i = 0; i <= 100; ++i) time.observe(0.1 * i, 0.01000001 * i);
  ASSERT_TRUE(time.seconds());
  EXPECT_EQ(*time.seconds(), 0);
}

// ---- numbers
// --------------------------------------------------------------------------------------

TEST(ProgressText, WritesDurations) {
  EXPECT_EQ(duration({}), "?");
  EXPECT_EQ(duration(std::nan("")), "?");
  EXPECT_EQ(duration(0.4), "0:00");
  EXPECT_EQ(duration(59.6), "1:00");
  EXPECT_EQ(duration(754), "12:34");
  EXPECT_EQ(duration(3 * 3600 + 7 * 60 + 9), "3:07:09");
  EXPECT_EQ(duration(51 * 3600), "2 d 03 h");
  EXPECT_EQ(duration(1e9), "> 99 d");
  EXPECT_EQ(duration(infinity), "> 99 d");
}

TEST(ProgressText, WritesCountsInAtMostFiveCharacters) {
  EXPECT_EQ(count(0), "0");
  EXPECT_EQ(count(99'999), "99999");
  EXPECT_EQ(count(100'000), "100k");
  EXPECT_EQ(count(999'499), "999k");
  EXPECT_EQ(count(999'600), "1.00M");
  EXPECT_EQ(count(45'600'000), "45.6M");
  EXPECT_EQ(count(7.89e9), "7.89G");
  for (double value = 1; value < 1e19; value *= 1.07) {
    EXPECT_LE(count(value).size(), 5U) << value;
  }
}

TEST(ProgressText, WritesTheGap) {
  EXPECT_EQ(gap(infinity, 1), "-");
  EXPECT_EQ(gap(1, -infinity), "-");
  EXPECT_EQ(gap(10, 9), "10 %");
  EXPECT_EQ(gap(-10, -10.5), "5 %");
  EXPECT_EQ(gap(10, 10), "0 %");
  EXPECT_EQ(gap(0, 0), "0 %");
  EXPECT_EQ(gap(0, -1), "> 999 %");
}

ProgressState some_state() {
  ProgressState state;
  state.progress = {.seconds = 754,
                    .opened = 1'234'567,
                    .open = 890,
                    .found = 27,
                    .closed = 0.4567,
                    .idle = 3,
                    .ranks = 8};
  state.nodes_per_second = 1637;
  state.remaining = 900;
  return state;
}

TEST(ProgressText, ARowHasAColumnUnderEachName) {
  for (const bool has_objective : {false, true}) {
    auto state = some_state();
    state.has_objective = has_objective;
    EXPECT_EQ(progress_row(state).size(), progress_header(has_objective).size());
    state.progress.objective = -123.456789;
    state.progress.bound = -130;
    state.remaining = {};
    EXPECT_EQ(progress_row(state).size(), progress_header(has_objective).size());
    EXPECT_LE(progress_header(has_objective).size(), has_objective ? 100U : 79U);
  }
}

TEST(ProgressText, ARowShowsKnownValues) {
  auto state = some_state();
  for (const char* part :
       {"12:34", " 1.23M", " 1637", " 890", " 27", " 3/8", " 45.6 %", " 15:00"}) {
    EXPECT_THAT(progress_row(state), HasSubstr(part));
  }
  state.has_objective = true;
  state.progress.objective = 10;
  state.progress.bound = 9;
  EXPECT_THAT(progress_row(state), HasSubstr("10            9    10 %"));
  state.progress.bound = infinity;  // no open node: the objective is its own bound
  EXPECT_THAT(progress_row(state), HasSubstr("10           10     0 %"));
}

TEST(ProgressText, NamesThePhaseAfterTheProof) {
  auto state = some_state();
  state.progress.objective = 10;
  state.progress.bound = 10;
  EXPECT_THAT(progress_row(state), HasSubstr(" 15:00"));  // searches for all solutions are not
                                                          // closed by a bound
  state.has_objective = true;
  EXPECT_THAT(progress_row(state), EndsWith("  closing"));
  EXPECT_THAT(progress_bar(state, 199), HasSubstr("closing: no better value is left"));
  EXPECT_EQ(progress_row(state).size(), progress_header(true).size());
  state.progress.bound = 9.99;
  EXPECT_THAT(progress_row(state), EndsWith(" 15:00"));
  state.progress.open = 0;
  EXPECT_THAT(progress_row(state), EndsWith("  ending"));
  EXPECT_THAT(progress_bar(state, 199), HasSubstr("ending: the ranks terminate"));
  // Without a point there is no proof, for any bound.
  state = some_state();
  state.has_objective = true;
  state.progress.bound = infinity;
  EXPECT_THAT(progress_row(state), EndsWith(" 15:00"));
}

TEST(ProgressText, DoesNotShow100PercentBeforeTheEnd) {
  auto state = some_state();
  state.progress.closed = 0.99999;
  EXPECT_THAT(progress_row(state), HasSubstr("99.9 %"));
  EXPECT_THAT(progress_bar(state, 79), Not(HasSubstr("####################")));
}

TEST(ProgressText, TheBarFitsItsTerminal) {
  const auto state = some_state();
  for (std::size_t width = 0; width < 200; ++width) {
    EXPECT_LE(progress_bar(state, width).size(), width);
  }
  EXPECT_THAT(progress_bar(state, 79),
              StartsWith("[#########...........]  45.6 %  15:00 left  27 found  12:34"));
  EXPECT_THAT(progress_bar(state, 199), HasSubstr("3/8 idle"));
  EXPECT_EQ(progress_bar(state, 10), "45.6 %");
}

TEST(ProgressText, RowsBecomeRareInALongSearch) {
  const auto rows_until = [](double end) {
    int rows = 0;
    for (double time = row_interval(0); time <= end; time += row_interval(time)) ++rows;
    return rows;
  };
  EXPECT_EQ(rows_until(60), 14);  // ten in 20 s, then one every 10 s
  EXPECT_LE(rows_until(12 * 3600.0), 200);
  EXPECT_GE(rows_until(12 * 3600.0), 100);
}

}  // namespace
}  // namespace kusabi::run
