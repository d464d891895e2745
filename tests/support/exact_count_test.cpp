// Counts beyond 2^53, 2^64 and any double, against powers that are known.
#include "support/exact_count.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace kusabi::support {
namespace {

ExactCount power(std::uint64_t base, std::size_t exponent) {
  return ExactCount::product(std::vector<std::uint64_t>(exponent, base));
}

TEST(ExactCount, DoesNotOverflow) {
  EXPECT_EQ(power(4, 32).digits(), "18446744073709551616");
  EXPECT_EQ(power(2, 128).digits(), "340282366920938463463374607431768211456");
  EXPECT_EQ(power(10, 400).digits(), '1' + std::string(400, '0'));
  EXPECT_EQ(ExactCount::product({}), 1U);
  EXPECT_EQ(power(0, 3), 0U);
}

TEST(ExactCount, IsANumberUpTo2ToThe53) {
  EXPECT_EQ(power(2, 53).number(), std::uint64_t{1} << 53U);
  EXPECT_FALSE(ExactCount((std::uint64_t{1} << 53U) + 1).number());
  EXPECT_FALSE(power(4, 32).number());
  EXPECT_EQ(ExactCount().number(), 0U);
}

TEST(ExactCount, HasALogarithmOfAnySize) {
  EXPECT_DOUBLE_EQ(power(10, 400).log10(), 400);
  EXPECT_DOUBLE_EQ(power(4, 600).log10(), 600 * std::log10(4.0));
  EXPECT_EQ(ExactCount().log10(), -std::numeric_limits<double>::infinity());
}

// 4^600 = 1.72226...e361, from its logarithm: 600 log10(4) = 361.2359...
TEST(ExactCount, IsShortenedInTextBeyondTheRangeOfDoubles) {
  EXPECT_EQ(power(4, 32).text(), "18446744073709551616");
  const double mantissa = std::pow(10, 600 * std::log10(4.0) - 361);
  const auto text = power(4, 600).text();
  EXPECT_NEAR(std::stod(text.substr(0, 6)), mantissa, 1.1e-4);
  EXPECT_EQ(text.substr(6), "e+361");
}

TEST(ExactCount, IsReadFromItsDigits) {
  EXPECT_EQ(ExactCount::read("18446744073709551616"), power(4, 32));
  EXPECT_EQ(ExactCount::read("0012"), 12U);
  EXPECT_EQ(ExactCount::read("000"), 0U);
  for (const auto* const wrong : {"", "-1", "1.5", "1e3", " 1", "inf"})
    EXPECT_FALSE(ExactCount::read(wrong)) << wrong;
  EXPECT_FALSE(ExactCount::read(std::string(2'000'000, '9')));
}

}  // namespace
}  // namespace kusabi::support
