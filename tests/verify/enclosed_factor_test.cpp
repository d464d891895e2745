// Interval factorisation of matrices that are too close to singular for doubles.
#include "verify/arithmetic/enclosed_factor.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "verify/arithmetic/cholesky.hpp"

namespace kusabi::verify {
namespace {

// [[1, 1], [1, 1 + change]].
DyadicList nearly_singular(const Dyadic& change) {
  return DyadicList(std::vector{Dyadic(1.0), Dyadic(1.0), Dyadic(1.0) + change});
}

TEST(EnclosedFactor, DecidesTheSignOfATinyPivot) {
  const Dyadic e(0x1p-80);
  EXPECT_FALSE(min_eigenvalue(Profile::full(2), nearly_singular(e)));
  const auto factor = EnclosedFactor::of(2, nearly_singular(e));
  ASSERT_TRUE(factor);
  const mpq_class bound = e.rational() / (2 + e.rational());  // 1 / trace of the inverse
  const auto found = factor->min_eigenvalue().rational();
  EXPECT_LE(found, bound);
  EXPECT_GT(found, bound * (1 - Dyadic(0x1p-200).rational()));
  const auto x = factor->solve({Enclosure(1.0), Enclosure(0.0)});
  EXPECT_LE(x[0].lower().rational(), 1 + 1 / e.rational());
  EXPECT_GE(x[0].upper().rational(), 1 + 1 / e.rational());
  EXPECT_LE(x[1].lower().rational(), -1 / e.rational());
  EXPECT_GE(x[1].upper().rational(), -1 / e.rational());
  EXPECT_LT((x[0].upper() - x[0].lower()).nearest(), 0x1p-100);
  EXPECT_FALSE(EnclosedFactor::of(2, nearly_singular(Dyadic())));
  EXPECT_FALSE(EnclosedFactor::of(2, nearly_singular(Dyadic() - e)));
}

// The inverse of the Hilbert matrix, 1 / (i + j + 1), has integer entries in closed form.
TEST(EnclosedFactor, BoundsTheLeastEigenvalueOfAHilbertMatrix) {
  constexpr int size = 14;
  long multiple = 1;  // makes all entries integers
  for (long k = 2; k < 2 * size; ++k) multiple = std::lcm(multiple, k);
  std::vector<double> lower;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j <= i; ++j) lower.push_back(static_cast<double>(multiple / (i + j + 1)));
  }
  mpz_class trace;  // of the inverse
  for (unsigned i = 0; i < size; ++i) {
    mpz_class first;
    mpz_class second;
    mpz_bin_uiui(first.get_mpz_t(), size + i, size - i - 1);
    mpz_bin_uiui(second.get_mpz_t(), 2 * i, i);
    trace += (2 * i + 1) * first * first * second * second;
  }
  EXPECT_FALSE(min_eigenvalue(Profile::full(size), DyadicList(lower)));
  const auto factor = EnclosedFactor::of(size, DyadicList(lower));
  ASSERT_TRUE(factor);
  const mpq_class bound = mpq_class(multiple) / trace;
  const auto found = factor->min_eigenvalue().rational();
  EXPECT_LE(found, bound);
  EXPECT_GT(found, bound * (1 - Dyadic(0x1p-200).rational()));
}

}  // namespace
}  // namespace kusabi::verify
