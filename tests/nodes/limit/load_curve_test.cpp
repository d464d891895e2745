// Curves with given breakpoints: all of them are found, and the end of the curve.
#include "nodes/limit/model/load_curve.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace kusabi::limit {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

double draw(std::mt19937& bits, double from, double to) {
  return from + (to - from) * (static_cast<double>(bits()) * 0x1p-32);
}

/// A concave curve by its breakpoints, which ends at the last one.
struct PiecewiseLinear {
  std::vector<double> at{0};
  std::vector<double> factor;
  std::vector<double> slope;

  explicit PiecewiseLinear(std::mt19937& bits) {
    factor.push_back(draw(bits, -5, 5));
    double steep = draw(bits, -1, 0);
    for (auto pieces = 1 + bits() % 6; pieces > 0; --pieces) {
      slope.push_back(steep);
      at.push_back(at.back() + draw(bits, 0.05, 1));
      factor.push_back(factor.back() + steep * (at.back() - at[at.size() - 2]));
      steep -= draw(bits, 0.01, 2);
    }
  }

  /// At a breakpoint the mode of either side, at random.
  [[nodiscard]] CurvePoint sample(double beta, std::mt19937& bits) const {
    std::size_t k = 0;
    while (k + 1 < slope.size() && at[k + 1] < beta - 1e-12) ++k;
    const bool corner = k + 1 < slope.size() && std::abs(at[k + 1] - beta) <= 1e-12;
    const double value = factor[k] + slope[k] * (beta - at[k]);
    if (corner && bits() % 2 == 0) ++k;
    return {beta, value, slope[k], {}};
  }

  void expect(const LoadCurve& found, double last) const {
    ASSERT_EQ(found.pieces.size(), slope.size());
    for (std::size_t k = 0; k < slope.size(); ++k) {
      const auto& piece = found.pieces[k];
      EXPECT_NEAR(piece.from.at, at[k], 1e-8);
      EXPECT_NEAR(piece.from.factor, factor[k], 1e-8);
      EXPECT_NEAR(piece.from.slope, slope[k], 1e-12);
      EXPECT_EQ(piece.to, k + 1 < slope.size() ? found.pieces[k + 1].from.at : last);
    }
  }
};

TEST(ConcaveCurve, HasAllBreakpoints) {
  std::mt19937 bits(1);  // NOLINT(cert-msc32-c,cert-msc51-cpp): repeatable on purpose
  for (int trial = 0; trial < 500; ++trial) {
    const PiecewiseLinear known(bits);
    std::size_t samples = 0;
    const auto found = concave_curve(
        [&](double beta) -> CurveSample {
          ++samples;
          return known.sample(beta, bits);
        },
        known.at.back(), 1e-10);
    known.expect(found, known.at.back());
    EXPECT_FALSE(found.end);
    EXPECT_LE(samples, 2 * known.slope.size() + 1);
  }
}

TEST(ConcaveCurve, BracketsItsEnd) {
  std::mt19937 bits(2);  // NOLINT(cert-msc32-c,cert-msc51-cpp): repeatable on purpose
  for (const double hint : {1.0, nowhere, 0.3, 1.0 + 1e-9, -1.0}) {
    for (int trial = 0; trial < 100; ++trial) {
      const PiecewiseLinear known(bits);
      const double end = known.at.back();
      const auto found = concave_curve(
          [&](double beta) -> CurveSample {
            if (beta > end) return NotCarried{end * hint, support::proved_if(beta > 1.5 * end)};
            return known.sample(beta, bits);
          },
          end*(trial % 4 == 0 ? 1e9 : draw(bits, 1.01, 1000)), 1e-10);
      ASSERT_TRUE(found.end);
      EXPECT_LE(found.end->carried_at, end);
      EXPECT_GT(found.end->not_carried_at, end);
      EXPECT_LE(found.end->not_carried_at - found.end->carried_at, 1e-6 * end);
      // A proof at the far place is not one at the near place.
      EXPECT_FALSE(is_proved(found.end->standing));
      known.expect(found, found.end->carried_at);
    }
  }
}

TEST(ConcaveCurve, IsAbsentIfASampleIsUnknown) {
  std::mt19937 bits(3);  // NOLINT(cert-msc32-c,cert-msc51-cpp): repeatable on purpose
  const PiecewiseLinear known(bits);
  for (int unknown = 0; unknown < 3; ++unknown) {
    int samples = 0;
    const auto found = concave_curve(
        [&](double beta) -> CurveSample {
          if (samples++ == unknown) return {};
          return known.sample(beta, bits);
        },
        known.at.back(), 1e-10);
    EXPECT_TRUE(found.pieces.empty());
  }
}

}  // namespace
}  // namespace kusabi::limit
