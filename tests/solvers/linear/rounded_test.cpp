// Tests of directed rounding against rational numbers: always on the safe side, and within two
// units of the last place.
#include "solvers/linear/rounded.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <gmpxx.h>
#include <gtest/gtest.h>

namespace kusabi::linear {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Expects that `down` is the truth rounded down: not above it, and, if tight, the second number
// above it is.
void expect_down(double down, const mpq_class& truth, bool tight) {
  if (down == -infinity) {
    EXPECT_LT(truth, mpq_class(-largest));
    return;
  }
  ASSERT_TRUE(std::isfinite(down)) << down;
  EXPECT_LE(mpq_class(down), truth);
  if (!tight || down == largest) return;
  const double next = std::nextafter(std::nextafter(down, infinity), infinity);
  if (next < infinity) {
    EXPECT_GT(mpq_class(next), truth);
  }
}

void expect_safe(double a, double b) {
  SCOPED_TRACE(testing::Message() << std::hexfloat << a << " and " << b);
  const mpq_class x(a);
  const mpq_class y(b);
  const mpq_class sum = x + y;
  const mpq_class product = x * y;
  expect_down(rounded::sum_down(a, b), sum, true);
  expect_down(-rounded::sum_up(a, b), -sum, true);
  expect_down(rounded::product_down(a, b), product, true);
  expect_down(-rounded::product_up(a, b), -product, true);
}

TEST(Rounded, IsOnTheSafeSideForNumbersOfAllSizes) {
  std::mt19937_64 draw(7);
  const auto any = [&] {
    for (;;) {
      const double number = std::bit_cast<double>(draw());
      if (std::isfinite(number)) return number;
    }
  };
  const auto ordinary = [&] {
    return std::ldexp(std::uniform_real_distribution<double>(-1, 1)(draw),
                      std::uniform_int_distribution<int>(-60, 60)(draw));
  };
  const auto subnormal = [&] {
    return static_cast<double>(std::uniform_int_distribution<int>(-50, 50)(draw)) * smallest;
  };
  const auto huge = [&] {
    return std::ldexp(std::uniform_real_distribution<double>(-1, 1)(draw), 1024);
  };
  for (int time = 0; time < 3000; ++time) {
    expect_safe(any(), any());
    expect_safe(ordinary(), ordinary());
    expect_safe(subnormal(), subnormal());
    expect_safe(subnormal(), ordinary());
    expect_safe(huge(), huge());
    expect_safe(huge(), ordinary());
    const double number = any();
    expect_safe(number, -std::nextafter(number, 0.0));  // complete cancellation
  }
}

TEST(Rounded, IsOnTheSafeSideAtTheLimitsOfTheRange) {
  for (const double a : {largest, -largest, smallest, -smallest, 0.0, 1.0, -1.0, 0x1p970, -0x1p970,
                         0x1p971, -0x1p971, 0x1.8p970}) {
    for (const double b : {largest, -largest, smallest, -smallest, 0.0, 1.0, 0x1p970, -0x1p970}) {
      expect_safe(a, b);
    }
  }
  EXPECT_EQ(rounded::sum_down(largest, largest), largest);
  EXPECT_EQ(rounded::sum_up(largest, largest), infinity);
  EXPECT_EQ(rounded::sum_down(-largest, -largest), -infinity);
  EXPECT_EQ(rounded::sum_up(-largest, -largest), -largest);
  EXPECT_EQ(rounded::product_down(largest, 2), largest);
  EXPECT_EQ(rounded::product_up(largest, 2), infinity);
  EXPECT_EQ(rounded::sum_down(infinity, -1), infinity) << "infinity is no overflow";
}

}  // namespace
}  // namespace kusabi::linear
