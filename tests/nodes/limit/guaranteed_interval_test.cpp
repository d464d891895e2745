// Combination of brackets: proofs of one bound are not claimed for the other.
#include "nodes/limit/guaranteed_interval.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace kusabi::limit {
namespace {

LimitWorstCase worst_case(double lower, double upper, bool lower_proved, bool upper_proved) {
  LimitWorstCase worst;
  worst.status = RootStatus::closed;
  worst.ends = {lower, upper, lower_proved, upper_proved};
  return worst;
}

// The factors of the opposite reference load are those of the original one with opposite signs.
TEST(GuaranteedInterval, NegatesTheFactorsOfTheReversedLoad) {
  LimitAnswer answer;
  answer.worst = worst_case(1.4, 1.5, true, false);
  answer.reversed = worst_case(-0.6, -0.5, false, true);
  const auto interval = guaranteed_interval(answer);
  EXPECT_EQ(interval.minimum.lower, 0.5);
  EXPECT_EQ(interval.minimum.upper, 0.6);
  EXPECT_TRUE(interval.minimum.lower_proved);
  EXPECT_FALSE(interval.minimum.upper_proved);
  EXPECT_TRUE(interval.has_factors());
  EXPECT_FALSE(interval.decided());  // from 0.6 on is not proved
}

TEST(GuaranteedInterval, HasNoMinusZero) {
  LimitAnswer answer;
  answer.worst = answer.reversed = worst_case(0, 0, true, true);
  EXPECT_FALSE(std::signbit(guaranteed_interval(answer).minimum.lower));
  EXPECT_FALSE(std::signbit(guaranteed_interval(answer).minimum.upper));
}

TEST(GuaranteedInterval, IsProvedEmptyByProvedBoundsOnly) {
  LimitAnswer answer;
  answer.worst = worst_case(0.4, 0.5, false, true);
  answer.reversed = worst_case(-1.6, -1.5, false, true);
  EXPECT_TRUE(guaranteed_interval(answer).is_empty());
  EXPECT_TRUE(guaranteed_interval(answer).decided());
  answer.worst->ends.upper_proved = false;
  EXPECT_FALSE(guaranteed_interval(answer).decided());
  answer.worst = worst_case(1.45, 1.55, true, true);
  EXPECT_FALSE(guaranteed_interval(answer).is_empty());
  EXPECT_FALSE(guaranteed_interval(answer).has_factors());
  EXPECT_FALSE(guaranteed_interval(answer).decided());
}

// Result of a stopped search: the least factors of the known loads.
TEST(GuaranteedInterval, IsBoundedByTheExaminedLoads) {
  LimitAnswer answer;
  answer.worst = worst_case(1, 2, true, true);
  answer.nominal_factors.minimum = {-4, -3.9, true, true};
  const auto interval = guaranteed_interval(answer);
  EXPECT_EQ(interval.minimum.lower, -4);
  EXPECT_TRUE(interval.minimum.lower_proved);
  EXPECT_EQ(interval.minimum.upper, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(interval.decided());
}

TEST(GuaranteedInterval, OfAllCasesIsTheirIntersection) {
  const GuaranteedInterval first{{-1, -0.9, true, true}, {2, 2.1, true, true}};
  const GuaranteedInterval second{{-0.95, -0.8, true, false}, {1.9, 2.2, true, true}};
  const std::array both{first, second};
  const auto all = intersection(both);
  EXPECT_EQ(all.minimum.lower, -0.95);
  EXPECT_TRUE(all.minimum.lower_proved);
  EXPECT_EQ(all.minimum.upper, -0.8);
  EXPECT_FALSE(all.minimum.upper_proved);
  EXPECT_EQ(all.largest.lower, 1.9);
  EXPECT_TRUE(all.largest.lower_proved);
  EXPECT_EQ(all.largest.upper, 2.1);
  EXPECT_TRUE(all.largest.upper_proved);
  GuaranteedInterval none;
  none.at_none = none.at_none_proved = true;
  const std::array with_none{first, none};
  EXPECT_TRUE(intersection(with_none).is_empty());
  EXPECT_TRUE(intersection(with_none).decided());
}

}  // namespace
}  // namespace kusabi::limit
