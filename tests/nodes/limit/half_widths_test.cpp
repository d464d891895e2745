// Uncertain loads with half-widths of the file or of groups, compared with all vertices and by
// exact proofs.
#include "problems/limit/half_widths.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "problems/files/structure_file.hpp"
#include "problems/files/toml/structure_writer.hpp"
#include "tests/nodes/limit/load_model.hpp"
#include "tests/nodes/limit/two_bars.hpp"

namespace kusabi::limit {
namespace {

using problems::RequestedHalfWidths;
using problems::Structure;
using test::near;
using test::PlainTruss;
using testing::HasSubstr;

// A complete analysis, by splitting if it has `split_from` uncertain loads or more. @return the
// problem with its half-widths, too
std::pair<LimitFindings, problems::LimitProblem> found(
    const Structure& truss, const RequestedHalfWidths& asked,
    int split_from = LimitParameters{}.split_from) {
  auto problem = problems::limit_problem(checked(truss));
  problems::LimitProblem* const one = &problem;
  const auto alpha = problems::set_half_widths({&one, 1}, asked);
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  return {limit_loads(analysis, truss, problem, {.alpha = alpha, .split_from = split_from}),
          problem};
}

// Every other parameter has a half-width in the file, the rest has the requested one.
TEST(HalfWidths, OfTheFileApplyToTheirParameters) {
  unsigned compared = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    auto [truss, alpha] = test::correlated_truss(seed);
    if (!test::problem_of(truss)) continue;
    auto& parameters = *truss.uncertain;
    auto all = truss;  // the result of all of them
    for (std::size_t j = 0; j < parameters.size(); ++j) {
      const double own = alpha * (0.3 + 0.35 * static_cast<double>(j));
      if (j % 2 == 0) parameters[j].half_width = own;
      (*all.uncertain)[j].half_width = j % 2 == 0 ? own : alpha;
    }
    const auto [findings, problem] = found(truss, {.alpha = alpha});
    const auto minimum = PlainTruss(all).min_over_corners(1);
    if (!minimum) continue;
    const auto& answer = findings.answer;
    ASSERT_TRUE(answer.worst && !findings.theorems.empty());
    const auto& theorem = findings.theorems.front();
    EXPECT_TRUE(answer.whole());
    EXPECT_NEAR(answer.worst->ends.at_most(), *minimum, near);
    for (const auto* file : {&truss, &all}) {
      const auto claim = test::shown(theorem, *file);
      EXPECT_EQ(claim.why, "");
      EXPECT_LE(claim.lower, *minimum + near);
      EXPECT_NEAR(claim.lower, claim.upper, near);
    }
    // The file, or the certificate, has another half-width.
    auto other = truss;
    other.uncertain->front().half_width = 1.125 * *parameters.front().half_width;
    EXPECT_THAT(test::shown(theorem, other).why, HasSubstr("half-width"));
    for (std::size_t j = 0; j < theorem.truss.half_widths.size(); ++j) {
      auto wider = theorem;
      *wider.truss.half_widths[j] *= 1.5;
      EXPECT_NE(test::shown(wider, all).why, "");
    }
    ++compared;
  }
  EXPECT_GE(compared, 10U);
}

// Half-widths by the name of a load or of a group: the same answer as with one alpha where they are
// equal, and as with weights.
TEST(HalfWidths, OfGroupsAreEquivalentToWeights) {
  const auto read = [](const std::string& weight, const std::string& group) {
    return problems::read_structure(two_bars(R"([[uncertainty]]
name = "across"
forces = [{ nodes = ["tip"], force = [1, -1] }]
)" + weight + "[[uncertainty]]\nnodes = [\"tip\"]\naxes = [\"y\"]\n" +
                                             group),
                                    "two-bars.toml");
  };
  const auto upper = [](const Structure& truss, const RequestedHalfWidths& asked) {
    const auto answer = found(truss, asked).first.answer;
    EXPECT_TRUE(answer.whole());
    return answer.worst->ends.at_most();
  };
  // q = (lambda + zeta, lambda - zeta + eta): 3 - 0.5, and 5 - 0.5 - 3 for a large eta.
  const auto open = read("", "group = \"side\"\n");
  EXPECT_NEAR(upper(open, {.alpha = 0.5}), 2.5, 1e-9);
  EXPECT_NEAR(upper(open, {.alpha = 0.5, .groups = {{"side", 3}}}), 1.5, 1e-9);
  EXPECT_NEAR(upper(open, {.alpha = 3, .groups = {{"across", 0.5}}}), 1.5, 1e-9);
  EXPECT_NEAR(upper(open, {.groups = {{"across", 0.5}, {"side", 3}}}), 1.5, 1e-9);
  EXPECT_NEAR(upper(read("alpha = 0.5\n", "alpha = 3\n"), {}), 1.5, 1e-9);
  for (const int split_from : {1, LimitParameters{}.split_from}) {
    const RequestedHalfWidths one_is_zero{.alpha = 0.5, .groups = {{"side", 0}}};
    const auto answer = found(open, one_is_zero, split_from).first.answer;
    EXPECT_TRUE(answer.whole()) << split_from;
    EXPECT_NEAR(answer.worst->ends.at_most(), 2.5, 1e-9);
  }
  const auto why = [](const Structure& truss, const RequestedHalfWidths& asked) -> std::string {
    try {
      found(truss, asked);
    } catch (const problems::HalfWidthError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(why(open, {.alpha = 1, .groups = {{"sied", 1}}}),
              HasSubstr("did you mean \"side\"?"));
  EXPECT_THAT(why(open, {.alpha = 1, .groups = {{"side", 1}, {"side", 2}}}), HasSubstr("twice"));
  EXPECT_THAT(why(open, {.groups = {{"side", 1}}}), HasSubstr("expected --alpha"));
  EXPECT_EQ(why(open, {.alpha = 0, .groups = {{"side", 1}}}), "no error");
  EXPECT_THAT(why(open, {.alpha = 1, .groups = {{"side", 1}, {"across", 2}}}),
              HasSubstr("expected no --alpha"));
  EXPECT_THAT(why(read("alpha = 1\n", ""), {.alpha = 2, .groups = {{"across", 1}}}),
              HasSubstr("the file says alpha = 1"));
}

// [lower, upper] is the middle and a half-width, for any alpha of the others.
TEST(HalfWidths, OfAnIntervalAreHalfItsLength) {
  const auto truss = problems::read_structure(R"(name = "one bar"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
left = [0, 0]
tip = [1, 0]
[[members]]
yield = 5
between = [["left", "tip"]]
[[supports]]
nodes = ["left"]
[[supports]]
nodes = ["tip"]
fixed = ["y"]
[[loads]]
kind = "reference"
nodes = ["tip"]
force = [1, 0]
[[loads]]
kind = "dead"
nodes = ["tip"]
force = [[-0.25, 1.75], 0]
)",
                                              "one-bar.toml");
  const auto [findings, problem] = found(truss, {});
  EXPECT_NEAR(findings.answer.nominal->factor, 4.25, 1e-9);
  EXPECT_NEAR(findings.answer.worst->ends.at_most(), 3.25, 1e-9);
  ASSERT_FALSE(findings.theorems.empty());
  EXPECT_EQ(test::shown(findings.theorems.front(), truss).why, "");
  const auto again = problems::read_structure(problems::structure_text(truss), "again");
  EXPECT_EQ(problems::limit_problem(again).fingerprint, problems::limit_problem(truss).fingerprint);
}

}  // namespace
}  // namespace kusabi::limit
