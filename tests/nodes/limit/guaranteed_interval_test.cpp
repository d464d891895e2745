// Combination of brackets: proofs of one bound are not claimed for the other.
#include "nodes/limit/guaranteed_interval.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace kusabi::limit {
namespace {

support::Bracket bracket(double lower, double upper, bool lower_proved, bool upper_proved) {
  return {support::Bound{lower, support::proved_if(lower_proved)},
          support::Bound{upper, support::proved_if(upper_proved)}};
}

LimitWorstCase worst_case(double lower, double upper, bool lower_proved, bool upper_proved) {
  LimitWorstCase worst;
  worst.status = RootStatus::closed;
  worst.ends = bracket(lower, upper, lower_proved, upper_proved);
  return worst;
}

// The factors of the opposite reference load are those of the original one with opposite signs.
TEST(GuaranteedInterval, NegatesTheFactorsOfTheReversedLoad) {
  LimitAnswer answer;
  answer.worst = worst_case(1.4, 1.5, true, false);
  answer.reversed = worst_case(-0.6, -0.5, false, true);
  const auto interval = guaranteed_interval(answer);
  EXPECT_EQ(interval.minimum.at_least(), 0.5);
  EXPECT_EQ(interval.minimum.at_most(), 0.6);
  EXPECT_TRUE(is_proved(interval.minimum.lower));
  EXPECT_FALSE(is_proved(interval.minimum.upper));
  EXPECT_TRUE(interval.has_factors());
  EXPECT_FALSE(is_proved(interval.standing()));  // from 0.6 on is not proved
}

TEST(GuaranteedInterval, HasNoMinusZero) {
  LimitAnswer answer;
  answer.worst = answer.reversed = worst_case(0, 0, true, true);
  EXPECT_FALSE(std::signbit(guaranteed_interval(answer).minimum.at_least()));
  EXPECT_FALSE(std::signbit(guaranteed_interval(answer).minimum.at_most()));
}

TEST(GuaranteedInterval, IsProvedEmptyByProvedBoundsOnly) {
  LimitAnswer answer;
  answer.worst = worst_case(0.4, 0.5, false, true);
  answer.reversed = worst_case(-1.6, -1.5, false, true);
  EXPECT_TRUE(guaranteed_interval(answer).is_empty());
  EXPECT_TRUE(is_proved(guaranteed_interval(answer).standing()));
  answer.worst->ends.upper->standing = support::Standing::computed;
  EXPECT_FALSE(is_proved(guaranteed_interval(answer).standing()));
  answer.worst = worst_case(1.45, 1.55, true, true);
  EXPECT_FALSE(guaranteed_interval(answer).is_empty());
  EXPECT_FALSE(guaranteed_interval(answer).has_factors());
  EXPECT_FALSE(is_proved(guaranteed_interval(answer).standing()));
}

// Result of a stopped search: the least factors of the known loads.
TEST(GuaranteedInterval, IsBoundedByTheExaminedLoads) {
  LimitAnswer answer;
  answer.worst = worst_case(1, 2, true, true);
  answer.nominal_factors.minimum = bracket(-4, -3.9, true, true);
  const auto interval = guaranteed_interval(answer);
  EXPECT_EQ(interval.minimum.at_least(), -4);
  EXPECT_TRUE(is_proved(interval.minimum.lower));
  EXPECT_FALSE(interval.minimum.upper);
  EXPECT_FALSE(is_proved(interval.standing()));
}

// The search was stopped before the worst case, or before it had an upper bound.
TEST(GuaranteedInterval, IsBoundedByTheNominalLoad) {
  LimitAnswer answer;
  answer.nominal_factors = {bracket(-4, -3.9, true, true), bracket(2.9, 3, true, false)};
  for (const bool begun : {false, true}) {
    if (begun) answer.worst.emplace();
    const auto interval = guaranteed_interval(answer);
    EXPECT_EQ(interval.minimum, (support::Bracket{answer.nominal_factors.minimum.lower, {}}));
    EXPECT_EQ(interval.largest, (support::Bracket{{}, answer.nominal_factors.largest.upper}));
    EXPECT_FALSE(interval.at_none);
  }
}

TEST(GuaranteedInterval, OfAllCasesIsTheirIntersection) {
  const GuaranteedInterval first{bracket(-1, -0.9, true, true), bracket(2, 2.1, true, true), {}};
  const GuaranteedInterval second{
      bracket(-0.95, -0.8, true, false), bracket(1.9, 2.2, true, true), {}};
  const std::array both{first, second};
  const auto all = intersection(both);
  EXPECT_EQ(all.minimum.at_least(), -0.95);
  EXPECT_TRUE(is_proved(all.minimum.lower));
  EXPECT_EQ(all.minimum.at_most(), -0.8);
  EXPECT_FALSE(is_proved(all.minimum.upper));
  EXPECT_EQ(all.largest.at_least(), 1.9);
  EXPECT_TRUE(is_proved(all.largest.lower));
  EXPECT_EQ(all.largest.at_most(), 2.1);
  EXPECT_TRUE(is_proved(all.largest.upper));
  GuaranteedInterval none;
  none.at_none = support::Standing::proved;
  const std::array with_none{first, none};
  EXPECT_TRUE(intersection(with_none).is_empty());
  EXPECT_TRUE(is_proved(intersection(with_none).standing()));
}

}  // namespace
}  // namespace kusabi::limit
