// The end of a pattern on a line: brackets contain the zero of t*, whatever t* looks like, and
// smooth functions take few programs.
#include "nodes/wedged/hold/end_search.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace kusabi::wedged {
namespace {

constexpr EndWidth width{1e-9, 1e-12};

struct Found {
  PatternEnd end;
  int programs = 0;
};

// @param margin t* at a point  @param tolerance of t*, within which its sign is not known
Found close_in(PatternEnd end, const std::function<double(double)>& margin, double tolerance = 0) {
  Found found;
  const auto answer_at = [&](double point) {
    ++found.programs;
    const double t = margin(point);
    if (std::abs(t) <= tolerance) return PointAnswer{HoldResult::unresolved, t};
    return PointAnswer{t > 0 ? HoldResult::feasible : HoldResult::infeasible, t};
  };
  found.end = close_in(end, width, answer_at, [] { return false; });
  return found;
}

void expect_bracket(const Found& found, double zero, int programs) {
  const auto& [feasible, infeasible, undecided] = found.end;
  EXPECT_FALSE(undecided);
  EXPECT_LE((feasible - zero) * (infeasible - zero), 0);
  EXPECT_LE(std::abs(feasible - infeasible), 1.0001e-9 * std::max(std::abs(zero), 1e-3));
  EXPECT_LE(found.programs, programs);
}

TEST(EndSearch, SmoothMarginsTakeLessThanHalfOfTheProgramsOfBisection) {
  constexpr double zero = 0.351958;
  expect_bracket(close_in({1, 0}, [](double mu) { return mu - zero; }), zero, 10);
  expect_bracket(close_in({1, 0}, [](double mu) { return mu / (1 + mu) - zero / (1 + zero); }),
                 zero, 14);
  expect_bracket(close_in({-1000, 0}, [](double x) { return std::tanh((-x - 17) / 300); }), -17,
                 14);
}

TEST(EndSearch, MarginsThatAreFlatOrHaveKinksOnTheSideWithStates) {
  constexpr double zero = 0.7;
  const auto flat = [](double x) { return x > zero ? 1e-3 : x - zero; };
  expect_bracket(close_in({1, 0}, flat), zero, 14);
  const auto kinked = [](double x) { return x > zero ? 1e4 * (x - zero) : 1e-4 * (x - zero); };
  expect_bracket(close_in({1, 0}, kinked), zero, 20);
}

// A jump, a power and a function with many pieces: bisection then leads.
TEST(EndSearch, MarginsWithoutAUsefulSecant) {
  constexpr double zero = 0.123456789;
  expect_bracket(close_in({1, 0}, [](double x) { return x > zero ? 1.0 : -1.0; }), zero, 45);
  expect_bracket(close_in({1, 0}, [](double x) { return std::pow(x - zero, 9); }), zero, 60);
  const auto pieces = [](double x) {
    const double off = x - zero;
    return std::copysign(std::exp2(std::floor(std::log2(std::abs(off) + 1e-300))), off);
  };
  expect_bracket(close_in({1, 0}, pieces), zero, 60);
}

TEST(EndSearch, UnknownMarginsAreBisected) {
  const auto found = close_in(
      {1, 0}, [](double x) { return x > 0.25 ? 1.0 : std::numeric_limits<double>::quiet_NaN(); });
  EXPECT_LE(found.end.infeasible, 0.25);
  EXPECT_GE(found.end.feasible, 0.25);
  EXPECT_LE(found.programs, 45);
}

TEST(EndSearch, BothSidesOfUndecidedPointsAreFound) {
  const auto found = close_in(
      {1, 0}, [](double x) { return x - 0.5; }, 1e-3);
  EXPECT_TRUE(found.end.undecided);
  EXPECT_NEAR(found.end.feasible, 0.501, 1e-8);
  EXPECT_NEAR(found.end.infeasible, 0.499, 1e-8);
}

TEST(EndSearch, AnEndAtZeroHasAnAbsoluteWidth) {
  const auto found = close_in({1, -1}, [](double x) { return x + 1e-14; });
  EXPECT_GE(found.end.feasible, -1e-14);
  EXPECT_LE(found.end.infeasible, -1e-14);
  EXPECT_LE(found.end.feasible - found.end.infeasible, 1e-12);
}

}  // namespace
}  // namespace kusabi::wedged
