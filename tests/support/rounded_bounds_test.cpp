// Decimal bounds remain bounds, and lower and upper ones differ.
#include "support/rounded_bounds.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace kusabi::support {
namespace {

TEST(ShownBracket, HasOneDecimalPlaceOnBothSidesOfAPowerOfTen) {
  const auto shown = in_sentence(0.999999999, 1.000000001);
  EXPECT_EQ(shown.lower, "0.99999");
  EXPECT_EQ(shown.upper, "1.00001");
}

TEST(ShownBracket, RoundsOutwards) {
  const auto shown = in_sentence(0.470271234, 0.470271244);
  EXPECT_EQ(shown.lower, "0.47027");
  EXPECT_EQ(shown.upper, "0.47028");
  const auto negative = in_sentence(-1.23456789, -1.23456788);
  EXPECT_EQ(negative.lower, "-1.2346");
  EXPECT_EQ(negative.upper, "-1.2345");
}

TEST(ShownBracket, InsideIsNeverEmpty) {
  const auto narrow = inside(0.333331, 0.333339);
  EXPECT_EQ(narrow.lower, "0.333331");
  EXPECT_EQ(narrow.upper, "0.333339");
  const auto wide = inside(-1.23456789, 1.23456789);
  EXPECT_EQ(wide.lower, "-1.2345");
  EXPECT_EQ(wide.upper, "1.2345");
  const double next = std::nextafter(0.1, 1.0);
  EXPECT_LE(std::stod(inside(0.1, next).lower), std::stod(inside(0.1, next).upper));
}

TEST(ShownBracket, InATableIsAtMostTwiceAsWide) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-6, 4);
  for (int i = 0; i < 2000; ++i) {
    const double lower = std::pow(10, exponent(random));
    const double upper = lower * (1 + std::pow(10, exponent(random) - 8));
    if (!(lower < upper)) continue;
    const auto shown = in_table(lower, upper);
    EXPECT_LE(std::stod(shown.lower), lower);
    EXPECT_GE(std::stod(shown.upper), upper);
    EXPECT_LT(std::stod(shown.lower), std::stod(shown.upper));
    EXPECT_LE(std::stod(shown.upper) - std::stod(shown.lower), 2.01 * (upper - lower)) << lower;
  }
}

TEST(ShownBracket, OfEqualBoundsIsEqual) {
  const auto shown = in_table(1.5, 1.5);
  EXPECT_EQ(std::stod(shown.lower), 1.5);
  EXPECT_EQ(std::stod(shown.upper), 1.5);
}

TEST(ShownBracket, OfATinyNumberHasAPowerOfTenAndFewDigits) {
  EXPECT_EQ(rounded_up(4.8689434088798864e-96), "4.869e-96");
  EXPECT_EQ(rounded_down(4.8689434088798864e-96), "4.8689e-96");
  EXPECT_EQ(rounded_down(-4.8689434088798864e-96), "-4.869e-96");
  EXPECT_EQ(rounded_up(9.999999e-30), "1e-29");
  EXPECT_EQ(in_sentence(0, 4.8689434088798864e-96).lower, "0");
  EXPECT_EQ(in_sentence(-5.12345678, 4.8689434088798864e-96).lower, "-5.1235");
}

TEST(ShownBracket, HasNoNumberOfTheEndOfTheRangeOfDoubles) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(rounded_down(-least, digits_of_table), "-1e-300");
  EXPECT_EQ(rounded_up(-least), "0");
  EXPECT_EQ(rounded_down(3e-310), "0");
  EXPECT_EQ(rounded_up(3e-310), "1e-300");
  EXPECT_EQ(rounded_up(1e-299), "1e-299");
  EXPECT_EQ(in_sentence(-least, 0).lower, "-1e-300");
  EXPECT_EQ(in_sentence(-least, 5).lower, "-1e-300");
  EXPECT_EQ(in_table(-2 * least, 0).lower, "-1e-300");
  EXPECT_EQ(in_table(-2 * least, 0).upper, "0");
}

TEST(ShownBracket, KeepsZero) {
  EXPECT_EQ(rounded_up(-0.0), "0");
  EXPECT_EQ(in_sentence(0, 1e-8).lower, "0");
  EXPECT_EQ(rounded_down(0), "0");
  EXPECT_EQ(rounded_down(0.5), "0.5");
  EXPECT_EQ(rounded_up(120), "120");
}

}  // namespace
}  // namespace kusabi::support
