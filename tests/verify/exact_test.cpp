// Exact arithmetic is lossless for numbers of any ratio.
#include "verify/arithmetic/exact.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "verify/limit/enclosed_sum.hpp"

namespace kusabi::verify {
namespace {

using Limits = std::numeric_limits<double>;

bool same(const Dyadic& a, const Dyadic& b) {
  return (a - b).sign() == 0;
}

TEST(Dyadic, KeepsEveryDouble) {
  for (const double x : {0.0, -0.0, 1.0, -1.5, 0.1, 1e300, -1e-300, Limits::max(), Limits::min(),
                         Limits::denorm_min(), -Limits::denorm_min()}) {
    EXPECT_EQ(Dyadic(x).nearest(), x);
    EXPECT_EQ(Dyadic(x).sign(), (x > 0) - (x < 0));
  }
}

TEST(Dyadic, AddsAndMultipliesExactly) {
  const Dyadic huge(1e300);
  const Dyadic tiny(1e-300);
  EXPECT_TRUE(same(huge + tiny - huge, tiny));
  EXPECT_TRUE(same(tiny + huge - huge, tiny));
  EXPECT_TRUE(same((huge + tiny) * (huge - tiny), huge * huge - tiny * tiny));
  EXPECT_TRUE(huge < huge + tiny);
  EXPECT_FALSE(huge + tiny < huge);
  EXPECT_TRUE(Dyadic(-1.0) < Dyadic{});
  EXPECT_FALSE(same(Dyadic(0.1) + Dyadic(0.2), Dyadic(0.3)));
}

// In rational numbers, for exponents in any order and sums that cancel.
TEST(Dyadic, AddsProductsExactly) {
  std::mt19937_64 generator(2);
  std::uniform_int_distribution<int> exponent(-200, 200);
  std::uniform_int_distribution<int> digit(-9, 9);
  for (int time = 0; time < 200; ++time) {
    Dyadic sum;
    mpq_class expected = 0;
    for (int k = 0; k < 6; ++k) {
      const Dyadic a = Dyadic(digit(generator)).scaled(exponent(generator)) + Dyadic(k % 2);
      const double b = std::ldexp(digit(generator) + 0.1, exponent(generator));
      for (const double factor : {b, k % 3 == 0 ? -b : 0.0, 1.0}) {
        sum.add_product(a, factor);
        expected += a.rational() * mpq_class(factor);
      }
    }
    EXPECT_EQ(sum.rational(), expected);
  }
  EXPECT_THROW(Dyadic().add_product(Dyadic(1.0), Limits::infinity()), std::domain_error);
}

// One last term leaves a sum of the order of the rounding errors of the others, two leave less than
// is known of it.
TEST(EnclosedSum, IsNotBelowTheExactSumAndHardlyAbove) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> number(-1, 1);
  std::uniform_int_distribution<int> exponent(-40, 40);
  for (int trial = 0; trial < 300; ++trial) {
    EnclosedSum sum;
    Dyadic expected;
    Dyadic errors;
    const auto add = [&](double b) {
      const Dyadic a = Dyadic(number(generator)) + Dyadic(number(generator)).scaled(-60) +
                       Dyadic(number(generator)).scaled(-200);
      const double error = trial % 2 == 0 ? 0 : 1e-10;
      sum.add(TwoDoubles::of(a, Dyadic(error)), b);
      expected.add_product(a, b);
      errors.add_product(Dyadic(error), std::abs(b));
    };
    for (int k = 0; k <= trial % 50; ++k) add(std::ldexp(number(generator), exponent(generator)));
    const int last = trial % 3;
    for (int k = 0; k < last; ++k) {
      const double nearest = expected.nearest();
      sum.add({1}, -nearest);
      expected.add_product(Dyadic(1.0), -nearest);
    }
    const auto above = sum.magnitude_above();
    if (last == 2 && !above) continue;
    ASSERT_TRUE(above);
    EXPECT_FALSE(Dyadic(*above) < absolute(expected) + errors);
    if (last == 2) continue;
    EXPECT_LE(*above, 1.001 * absolute(expected).nearest() + 1.001 * errors.nearest());
  }
}

TEST(EnclosedSum, CountsTheErrorOfAZero) {
  EnclosedSum sum;
  sum.add(TwoDoubles::of({}, Dyadic(1e-3)), 2);
  EXPECT_FALSE(sum.magnitude_above());
  sum.add({1}, 1);
  EXPECT_GE(sum.magnitude_above().value_or(0), 1.002);
}

TEST(EnclosedSum, HasNoBoundIfItMayBeZero) {
  EnclosedSum sum;
  EXPECT_EQ(sum.magnitude_above(), 0.0);
  const auto third = TwoDoubles::of(Dyadic(1.0 / 3), {});
  sum.add(third, 3);
  sum.add(third, -3);
  EXPECT_FALSE(sum.magnitude_above());
}

TEST(Dyadic, RootIsATightUpperBound) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> exponent(-1000, 1000);
  const Dyadic a_little_more(1 + 0x1p-50);
  for (int i = 0; i < 2000; ++i) {
    const Dyadic x(std::exp2(exponent(generator)));
    const auto root = sqrt_above(x);
    EXPECT_FALSE(root * root < x);
    EXPECT_TRUE(root * root < x * a_little_more);
  }
  EXPECT_TRUE(same(sqrt_above(Dyadic(9.0)), Dyadic(3.0)));
  EXPECT_TRUE(same(sqrt_above(Dyadic(0.25)), Dyadic(0.5)));
  EXPECT_EQ(sqrt_above(Dyadic{}).sign(), 0);
}

TEST(DyadicList, KeepsItsValues) {
  const std::vector<double> values{0, 1e-300, -3, 1e300, Limits::denorm_min()};
  const DyadicList list(values);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_TRUE(same(list[i], Dyadic(values[i])));
  EXPECT_EQ(DyadicList(std::vector<double>(3, 0.0))[2].sign(), 0);
}

TEST(DyadicList, TruncatesNegligibleValues) {
  const std::vector<double> values{1, 1e-300, -1e-300, -3};
  const DyadicList list(values, 64);
  EXPECT_TRUE(same(list[0], Dyadic(1.0)));
  EXPECT_EQ(list[1].sign(), 0);
  EXPECT_EQ(list[2].sign(), 0);
  EXPECT_TRUE(same(list[3], Dyadic(-3.0)));
}

TEST(DyadicList, AddsExactly) {
  const std::vector<double> large{1e200, 3, 0};
  const std::vector<double> small{1e-200, 0.1, -1e-300};
  auto sum = DyadicList(large);
  sum += DyadicList(small);
  auto other = DyadicList(small);
  other += DyadicList(large);
  DyadicList from_nothing(3);
  from_nothing += DyadicList(small);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(same(sum[i], Dyadic(large[i]) + Dyadic(small[i])));
    EXPECT_TRUE(same(other[i], sum[i]));
    EXPECT_TRUE(same(from_nothing[i], Dyadic(small[i])));
  }
}

TEST(Dyadic, RefusesInfinityAndNan) {
  for (const double wrong :
       {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Dyadic{wrong}, std::domain_error);
  }
}

TEST(DyadicMatrix, MultipliesExactly) {
  const std::vector<double> entries{1, 1e200, -1e-200, 3};
  const std::vector<double> x{1e-200, 0.1};
  const DyadicMatrix matrix{2, DyadicList(entries)};
  const auto product = matrix * DyadicList(x);
  EXPECT_TRUE(same(product[0], Dyadic(1e-200) + Dyadic(1e200) * Dyadic(0.1)));
  EXPECT_TRUE(same(product[1], Dyadic(3.0) * Dyadic(0.1) - Dyadic(1e-200) * Dyadic(1e-200)));
}

}  // namespace
}  // namespace kusabi::verify
