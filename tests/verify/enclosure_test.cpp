// Intervals contain the exact results, and are narrow.
#include "verify/arithmetic/enclosure.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace kusabi::verify {
namespace {

Dyadic width(const Enclosure& x) {
  return x.upper() - x.lower();
}

bool within(const Enclosure& x, const mpq_class& value) {
  return x.lower().rational() <= value && value <= x.upper().rational();
}

TEST(Enclosure, OfADoubleIsExact) {
  for (const double value : {0.0, 1.0, -0.1, 1e308, 0x1p-1074}) {
    EXPECT_EQ(width(Enclosure(value)).sign(), 0);
    EXPECT_TRUE(within(Enclosure(value), Dyadic(value).rational()));
  }
  EXPECT_TRUE((Enclosure(1.0) - Enclosure(1.0)).is_zero());
  EXPECT_FALSE((Enclosure(1.0) - Enclosure(0x1p-200)).is_zero());
}

TEST(Enclosure, ContainsAThirdAndARoot) {
  const auto third = Enclosure(1) / Enclosure(3);
  EXPECT_TRUE(within(third, mpq_class(1, 3)));
  EXPECT_LT(width(third).nearest(), 0x1p-310);
  EXPECT_GT(width(third).sign(), 0);
  const auto root = sqrt(Enclosure(2));
  EXPECT_LT(square(root.lower()).rational(), 2);
  EXPECT_GT(square(root.upper()).rational(), 2);
  EXPECT_LT(width(root).nearest(), 0x1p-310);
}

TEST(Enclosure, IsNotFiniteForUndefinedOperations) {
  EXPECT_FALSE((Enclosure(1) / Enclosure(0)).finite());
  EXPECT_FALSE(
      (Enclosure(1) / (Enclosure(1) / Enclosure(3) - Enclosure(1) / Enclosure(3))).finite());
  EXPECT_FALSE(sqrt(Enclosure(-1)).finite());
  const auto none = sqrt(Enclosure(-1));
  EXPECT_FALSE((none * Enclosure(2)).finite());
  EXPECT_FALSE((Enclosure(0) * none).finite());
  EXPECT_FALSE((none + Enclosure(2)).finite());
  EXPECT_FALSE((Enclosure(1) / none).finite());
  EXPECT_FALSE(magnitude(none).finite());
}

// Intervals around random thirds, with signs of all kinds, compared with rational arithmetic at and
// between their bounds.
TEST(Enclosure, ContainsAllResultsOfOperations) {
  std::mt19937_64 generator(3);
  std::uniform_int_distribution<int> number(-4, 4);
  const auto interval = [&] {
    // [a, b] as the sum of an interval around zero and a number.
    const double spread = std::abs(number(generator));
    const auto around = magnitude(Enclosure(1) - Enclosure(1)) + Enclosure(number(generator));
    const auto wide = sqrt(Enclosure(spread * spread)) * (Enclosure(1) / Enclosure(3));
    return (number(generator) > 0 ? wide : -wide) + around;
  };
  for (int trial = 0; trial < 2000; ++trial) {
    const auto a = interval();
    const auto b = interval();
    for (const auto& x : {a.lower().rational(), a.upper().rational()}) {
      for (const auto& y : {b.lower().rational(), b.upper().rational()}) {
        EXPECT_TRUE(within(a + b, x + y));
        EXPECT_TRUE(within(a - b, x - y));
        EXPECT_TRUE(within(a * b, x * y));
        const auto quotient = a / b;
        if (quotient.finite()) {
          EXPECT_TRUE(within(quotient, mpq_class(x / y)));
        } else {
          EXPECT_TRUE(within(b, 0));
        }
        EXPECT_TRUE(within(-a, -x));
        EXPECT_TRUE(within(magnitude(a), abs(x)));
      }
    }
  }
}

TEST(Enclosure, BoundsItsDistanceFromANumber) {
  const auto third = Enclosure(1) / Enclosure(3);
  const auto distance = third.distance(Dyadic(0.25)).rational();
  EXPECT_GE(distance, mpq_class(1, 12));
  EXPECT_LT(distance.get_d(), 1.0 / 12 * (1 + 1e-15));
}

}  // namespace
}  // namespace kusabi::verify
