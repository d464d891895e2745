// Tables of `kusabi limit`: standings and rounded bounds of answers as they are given.
#include "run/limit/limit_report.hpp"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "run/pictures/limit_values.hpp"
#include "tests/nodes/limit/two_bars.hpp"

namespace kusabi::run {
namespace {

using testing::HasSubstr;
using testing::Not;

std::array<LimitCase, 1> two_bars() {
  const auto truss =
      problems::checked(problems::read_structure(limit::two_bars(""), "two-bars.toml"));
  return {LimitCase{"", truss, problems::limit_problem(truss)}};
}

// The proof of a load that is not carried does not depend on what was left out later.
TEST(LimitReport, KeepsAProofAfterAnEarlyEnd) {
  auto cases = two_bars();
  auto& answer = cases.front().found.answer;
  answer.status = limit::LoadStatus::not_carried;
  answer.rest = engine::Status::time_limit;
  const LimitOptions options;
  const auto table = LimitReport(options, cases, cases.front(), 1).table(Page{});
  EXPECT_THAT(table, HasSubstr("of either sign, proved"));
}

limit::LoadCurve one_piece(std::optional<double> error) {
  const double end = 0.123456789123;
  limit::LoadCurve curve;
  curve.pieces.push_back({.from = {.at = 0, .factor = 3, .slope = -1, .motion = {}},
                          .to = end,
                          .factor_at_end = 3 - end,
                          .error = error});
  curve.pieces.front().from.motion = Eigen::VectorXd::Zero(2);
  curve.end = limit::CurveEnd{end, end, support::Standing::proved};
  return curve;
}

TEST(CurveText, RoundsTheEndUpAndGivesTheProvedDistance) {
  const auto cases = two_bars();
  const auto text = curve_text(cases.front().problem, one_piece(1e-3), "beta", "some load");
  EXPECT_THAT(text, HasSubstr("0.12345678    2.876543211"));
  EXPECT_THAT(text,
              HasSubstr("0.12345679  some load is carried at no factor from here on, proved"));
  EXPECT_THAT(text, HasSubstr("each factor is within 0.0011 of that of the curve, proved"));
  EXPECT_THAT(curve_text(cases.front().problem, one_piece({}), "beta", "some load"),
              testing::AllOf(Not(HasSubstr("within")), HasSubstr("(computed, not proved)")));
}

TEST(CurveText, KeepsTheDigitsOfSmallFactors) {
  auto curve = one_piece(0);
  auto& piece = curve.pieces.front();
  piece.from.factor = 3.25e-9;
  piece.from.slope = -1e-9;
  piece.factor_at_end = 3.25e-9 - 1e-9 * piece.to;
  const auto text = curve_text(two_bars().front().problem, curve, "beta", "some load");
  EXPECT_THAT(text, HasSubstr(" 3.25e-09  "));
  EXPECT_THAT(text, HasSubstr("3.126543211e-09"));
  EXPECT_THAT(text, HasSubstr("within 1.6e-17 of that"));
}

}  // namespace
}  // namespace kusabi::run
