// Error bounds of coarse matrices compared with exact products; and proofs that require the exact
// matrix.
#include "verify/arithmetic/truncated_matrix.hpp"

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "verify/structure/regularised_stiffness.hpp"

namespace kusabi::verify {
namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  mpz_class number(unsigned bits) {
    mpz_class value = 1;
    for (unsigned k = 1; k < bits; ++k) value = 2 * value + static_cast<int>(random_() & 1U);
    return (random_() & 1U) != 0 ? value : mpz_class(-value);
  }
  unsigned below(unsigned count) { return static_cast<unsigned>(random_() % count); }

 private:
  std::mt19937_64 random_;
};

DyadicMatrix random_matrix(Draw& draw, std::size_t size, unsigned bits) {
  DyadicMatrix matrix{.size = size, .entries = DyadicList(size * size)};
  matrix.entries.exponent = static_cast<long>(draw.below(200)) - 100;
  for (auto& entry : matrix.entries.mantissas) entry = draw.number(1 + draw.below(bits));
  return matrix;
}

DyadicList random_vector(Draw& draw, std::size_t size, unsigned bits) {
  DyadicList x(size);
  x.exponent = static_cast<long>(draw.below(200)) - 100;
  for (auto& entry : x.mantissas) entry = draw.number(1 + draw.below(bits));
  return x;
}

DyadicList difference(DyadicList a, DyadicList b) {
  for (auto& entry : b.mantissas) entry = -entry;
  a += std::move(b);
  return a;
}

TEST(TruncatedMatrix, SatisfiesItsErrorBound) {
  Draw draw(7);
  for (int trial = 0; trial < 300; ++trial) {
    const auto size = std::size_t{1} + draw.below(20);
    const auto matrix = random_matrix(draw, size, 1 + draw.below(300));
    const auto x = random_vector(draw, size, 62);
    const TruncatedMatrix coarse(matrix);
    const auto product = coarse * x;
    ASSERT_TRUE(product);
    const auto off = norm_above(difference(matrix * x, *product));
    EXPECT_FALSE(off > coarse.cut_off() * norm_above(x)) << trial;
  }
}

// The largest possible sums.
TEST(TruncatedMatrix, SumsDoNotOverflow) {
  constexpr std::size_t size = 1024;
  const auto largest = [](unsigned bits) -> mpz_class { return (mpz_class(1) << bits) - 1; };
  for (const int sign : {-1, 1}) {
    DyadicMatrix matrix{.size = size, .entries = DyadicList(size * size)};
    for (auto& entry : matrix.entries.mantissas) entry = sign * largest(54);
    DyadicList x(size);
    for (auto& entry : x.mantissas) entry = largest(62);
    const TruncatedMatrix coarse(matrix);
    EXPECT_EQ(coarse.cut_off().sign(), 0);
    const auto product = coarse * x;
    ASSERT_TRUE(product);
    const mpz_class sum = sign * largest(54) * largest(62) * static_cast<int>(size);
    EXPECT_EQ(product->mantissas.front(), sum);
    EXPECT_EQ(product->mantissas.back(), sum);
  }
}

TEST(TruncatedMatrix, RefusesTooLargeNumbersAndSizes) {
  Draw draw(3);
  const TruncatedMatrix coarse(random_matrix(draw, 3, 60));
  auto x = random_vector(draw, 3, 62);
  EXPECT_TRUE(coarse * x);
  x.mantissas[1] = mpz_class(1) << 62U;
  EXPECT_FALSE(coarse * x);
  const TruncatedMatrix large({.size = 1025, .entries = DyadicList(std::size_t{1025} * 1025)});
  EXPECT_FALSE(large * DyadicList(std::size_t{1025}));
}

// K = diag(1, 2^-30) + 2^-200: the coarse matrix has lost the last term.
TEST(RegularisedStiffness, UsesTheExactMatrixIfTheTruncatedOneIsUndecided) {
  DyadicMatrix middle{.size = 2, .entries = DyadicList(std::size_t{4})};
  middle.entries.exponent = -200;
  middle.entries.mantissas[0] = (mpz_class(1) << 200U) + 1;
  middle.entries.mantissas[3] = (mpz_class(1) << 170U) + 1;
  const RegularisedStiffness held({middle, {}}, {});
  const auto all = first_numbers(2);
  const std::vector<double> right{1, 1};
  int coarse = 0;
  int exact = 0;
  const auto refusal =
      held.solve(all, DyadicList(right),
                 [&](const DyadicList& x, const DyadicList& kx,
                     const Dyadic& off) -> std::optional<std::string> {
                   const auto error = norm_above(difference(middle * x, kx));
                   EXPECT_FALSE(error > off);
                   ++(off.sign() == 0 ? exact : coarse);
                   if (off.sign() != 0) return "not sharp enough";
                   return norm_above(difference(kx, DyadicList(right))) > Dyadic(1e-30)
                              ? std::optional<std::string>("not near enough")
                              : std::nullopt;
                 });
  EXPECT_FALSE(refusal) << *refusal;
  EXPECT_EQ(coarse, 1);
  EXPECT_GE(exact, 1);
}

}  // namespace
}  // namespace kusabi::verify
