// `kusabi mip` as a user calls it: programs that earlier versions got wrong, messages, and early
// stops.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"

namespace {

using kusabi::test::command;
using kusabi::test::content;
using kusabi::test::quoted;
using kusabi::test::ranks;
using kusabi::test::shell;
using testing::HasSubstr;
using testing::Not;

class MipCommand : public kusabi::test::Command {
 protected:
  struct Answer {
    int exit_code;
    std::string said;
    nlohmann::json result;
  };

  // A file given by its path.
  [[nodiscard]] Answer solve(const std::string& file, const std::string& options = "",
                             const std::string& launcher = "") const {
    const auto json = in_folder("answer.json");
    const auto run = shell(launcher + command + " mip " + quoted(file) + " " + options +
                           " --output " + quoted(json));
    Answer answer{run.exit_code, run.output, {}};
    if (std::ifstream(json)) answer.result = nlohmann::json::parse(content(json))["result"];
    return answer;
  }

  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(in_folder(name)) << text;
    return in_folder(name);
  }
};

std::string source(const std::string& name) {
  return std::string(KUSABI_SOURCE_DIR) + "/tests/" + name;
}

const std::vector<std::string> ways{"", "--cuts disjunctive", "--no-tighten --no-dive",
                                    "--branching look-ahead",
                                    "--cuts disjunctive --no-dive --branching look-ahead"};

TEST_F(MipCommand, SolvesProgramsThatWereOnceSolvedWrongly) {
  struct Known {
    const char* name;
    double optimum;
  };
  for (const auto& [name, optimum] :
       {Known{"penalty_min.mps", 48}, Known{"objective_rhs.mps", 13}, Known{"root_nan.mps", 0}}) {
    for (const auto& way : ways) {
      const auto answer = solve(source("cases/") + name, way);
      EXPECT_EQ(answer.exit_code, 0) << name << answer.said;
      ASSERT_EQ(answer.result["state"], "optimal") << name << way;
      EXPECT_NEAR(answer.result["objective"], optimum, 1e-12) << name << way;
      EXPECT_NEAR(answer.result["bound"]["value"], optimum, 1e-6) << name << way;
      // Columns without bounds are bounded only by a point, which the dive finds.
      if (way.find("--no-dive") != std::string::npos) continue;
      EXPECT_EQ(answer.result["bound"]["standing"], "proved") << name << way;
    }
  }
  const auto none = solve(source("cases/no_entries.mps"));
  EXPECT_EQ(none.exit_code, 0) << none.said;
  EXPECT_EQ(none.result["state"], "infeasible");
  EXPECT_THAT(none.said, Not(HasSubstr("not proved")));
  EXPECT_EQ(none.result["standing"], "proved");
}

// Bound tightening once reduced M from 1000 to 1e-117. By hand: y = z = 1 and w = 4/9 in bigm_tiny;
// in bigm_open_a x14 is 4 by r2 if x6 = x9 = 1, and then r5 gives x0 = 0: -28 - 3; with x9 = 0 at
// best -9 - 15.75.
TEST_F(MipCommand, KeepsTheScaleOfABigM) {
  for (const auto& way : ways) {
    const auto open = solve(source("cases/bigm_open_a.mps"), way);
    EXPECT_EQ(open.exit_code, 0) << way << open.said;
    EXPECT_EQ(open.result["state"], "optimal") << way;
    EXPECT_NEAR(open.result["objective"], -31, 1e-9) << way;
    const auto tiny = solve(source("cases/bigm_tiny.mps"), way);
    EXPECT_EQ(tiny.exit_code, 0) << way << tiny.said;
    EXPECT_NEAR(tiny.result["objective"], -8 + 4.0 / 9, 1e-9) << way;
    if (way.find("--no-tighten") != std::string::npos || way.find("--no-dive") != way.npos)
      continue;
    EXPECT_EQ(tiny.result["root"]["tightened"], 1) << way;
  }
}

// Both optima are from rational arithmetic (bench/hostile/exact_program.py).
TEST_F(MipCommand, VerifiesInfeasibilityReportedByTheSimplexMethod) {
  // x0 = 0, x3 = x4 = 1: r1 is tight to the last digit, and no basis in doubles has that point.
  const auto tight = solve(source("cases/tight_rows.lp"));
  EXPECT_EQ(tight.exit_code, 0) << tight.said;
  EXPECT_NEAR(tight.result["objective"], -301.3, 1e-9);
  // By r2, x6 is 1.2e11 at most, and r0 couples x7 to it: no direction decreases the objective.
  const auto bounded = solve(source("cases/bounded_by_a_binary.mps"));
  EXPECT_EQ(bounded.exit_code, 0) << bounded.said;
  EXPECT_EQ(bounded.result["state"], "optimal");
}

// Truths by hand. ff24: x = b = -a = 1e24 and c = 0. chain: 1000^4 and (1e7)^3. b_1e12, b_small: only
// b = 1 leaves r2 room for y1 + y2 = 1; in b_1e12 a column beside them is 1e12. tiny_optimum: b = 1.
TEST_F(MipCommand, HasTolerancesOfTheTermsOfARowAlone) {
  struct Known {
    const char* name;
    double optimum;
  };
  for (const auto& [name, optimum] :
       {Known{"ff24.mps", 0}, Known{"b_1e12.mps", 1}, Known{"b_small.mps", 1},
        Known{"chain1e3.lp", 1e12}, Known{"chain1e7.lp", 1e21}, Known{"tiny_optimum.lp", 5e-11}}) {
    for (const auto& way : ways) {
      const auto answer = solve(source("cases/") + name, way);
      EXPECT_EQ(answer.exit_code, 0) << name << way << answer.said;
      ASSERT_EQ(answer.result["state"], "optimal") << name << way;
      EXPECT_EQ(answer.result["objective"], optimum) << name << way;
      EXPECT_NEAR(answer.result["bound"]["value"], optimum, 1e-8 * optimum) << name << way;
      EXPECT_EQ(answer.result["bound"]["standing"], "proved") << name << way;
      EXPECT_EQ(answer.result["standing"], "proved") << name << way;
    }
  }
  const auto unread = solve(source("cases/lp_range_and_constant.lp"));
  EXPECT_EQ(unread.exit_code, 2);
  EXPECT_THAT(unread.said, HasSubstr("lp_range_and_constant.lp:2: a constant in the objective"));
}

// A tightened M of zero was once taken for a coefficient by which to divide. x0 = 1, x3 = 1e4 and
// x4 = 1e5: 900 - 10 - 7000, and no column can decrease the objective further.
TEST_F(MipCommand, KeepsAllPointsWhenAnMBecomesZero) {
  const auto answer = solve(source("cases/m_becomes_zero.mps"));
  EXPECT_EQ(answer.exit_code, 0) << answer.said;
  EXPECT_NEAR(answer.result["objective"], -6110, 1e-9);
}

// By hand: tau = 1 needs x of 0.8, one rounding error above its bound, so s = 1 and tau = 0; and all
// variables are zero, as x = 1 costs s = t = 1.
TEST_F(MipCommand, ProvesNoPointOfARowThatIsOneRoundingErrorLaxer) {
  for (const auto& way : ways) {
    EXPECT_EQ(solve(source("cases/m_one_rounding_laxer.lp"), way).result["objective"], 3) << way;
    EXPECT_EQ(solve(source("cases/reduced_cost_one_rounding_off.lp"), way).result["objective"], 0)
        << way;
  }
}

// With cuts and columns without bounds the bound is computed, and so is the optimum.
TEST_F(MipCommand, CallsAnOptimumProvedIfItsBoundIs) {
  const auto file = source("cases/free_columns_with_cuts.lp");
  EXPECT_THAT(solve(file).said, testing::HasSubstr("The optimum is -7 (proved)"));
  const auto with_cuts = solve(file, "--cuts disjunctive");
  if (with_cuts.result["bound"]["standing"] == "computed") {
    EXPECT_THAT(with_cuts.said, testing::Not(testing::HasSubstr("The optimum is -7 (proved)")));
  }
}

// A stopped search makes true claims: of a point, of a bound, or of neither.
TEST_F(MipCommand, SaysWhatHoldsWhenItIsStopped) {
  for (const auto& [name, optimum] : {std::pair{"tiny_optimum.lp", 5e-11}, {"b_1e12.mps", 1.0}}) {
    for (const char* way : {"--node-limit 1 --no-dive --no-tighten", "--node-limit 1"}) {
      const auto answer = solve(source("cases/") + name, way);
      const auto& result = answer.result;
      EXPECT_NE(result["state"], "infeasible") << name << way;
      if (!result["bound"].is_null()) {
        EXPECT_LE(result["bound"]["value"], optimum) << name << way;
      }
      if (!result["objective"].is_null()) {
        EXPECT_GE(result["objective"], optimum) << name << way;
      }
    }
  }
}

TEST_F(MipCommand, SolvesSmallProgramsOfTheClassicKinds) {
  struct Known {
    const char* name;
    double optimum;
  };
  for (const auto& [name, optimum] : {Known{"set-cover.mps", 5}, Known{"p-median.mps", 11},
                                      Known{"generalised-assignment.mps", 27}}) {
    for (const auto& way : ways) {
      const auto answer = solve(source("programs/") + name, way);
      EXPECT_EQ(answer.exit_code, 0) << name << way;
      EXPECT_EQ(answer.result["state"], "optimal") << name << way;
      EXPECT_NEAR(answer.result["objective"], optimum, 1e-9) << name << way;
    }
  }
}

TEST_F(MipCommand, ReportsUnboundedProgramsInBothSensesAndWithBoundsOf1e30) {
  const auto program = [](const char* sense, const char* bound) {
    return fmt::format(
        "{}NAME T\nROWS\n N c\n L l\nCOLUMNS\n M 'MARKER' 'INTORG'\n b c 1 l 1\n M 'MARKER' "
        "'INTEND'\n x c 2\n x l -1\nRHS\n R l 4\nBOUNDS\n UP B b 1\n{}ENDATA\n",
        sense, bound);
  };
  for (const auto& text :
       {program("OBJSENSE MAX\n", ""), program("OBJSENSE MAX\n", " UP B x 1e30\n"),
        program("", " LO B x -1e30\n UP B x 7\n")}) {
    const auto unbounded =
        solve(file("u.mps", text.find("LO B x") == std::string::npos
                                ? text
                                : std::string(text).replace(text.find("x l -1"), 6, "x l  1")));
    EXPECT_EQ(unbounded.exit_code, 0) << unbounded.said;
    EXPECT_EQ(unbounded.result["state"], "unbounded") << text;
  }
  const auto bounded = solve(file("b.mps", program("OBJSENSE MAX\n", " UP B x 1e6\n")));
  EXPECT_EQ(bounded.result["state"], "optimal");
  EXPECT_NEAR(bounded.result["objective"], 2e6 + 1, 1e-3);
}

// 2 (b1 + b2 + b3) = 3 has no solution, which its relaxation does not show.
TEST_F(MipCommand, IsNotAnsweredByAStoppedSearchOfAnUnboundedProgram) {
  const auto text = file("u.lp",
                         "Minimize\n c: - x\nSubject To\n e: 2 b1 + 2 b2 + 2 b3 = 3\n"
                         "Binary\n b1 b2 b3\nEnd\n");
  const auto stopped = solve(text, "--node-limit 1 --no-dive --no-tighten");
  EXPECT_EQ(stopped.exit_code, 3) << stopped.said;
  EXPECT_EQ(stopped.result["state"], "unknown");
  EXPECT_TRUE(stopped.result["bound"].is_null());
  EXPECT_TRUE(stopped.result["root"]["last_bound"].is_null());
  EXPECT_THAT(stopped.said, HasSubstr("lower bound not known"));
  EXPECT_EQ(solve(text).result["state"], "infeasible");
}

TEST_F(MipCommand, WarnsOfANegativeUpperBound) {
  const auto answer = solve(
      file("w.mps",
           "ROWS\n N c\n G g\nCOLUMNS\n x c 1 g 1\nRHS\n R g -9\nBOUNDS\n UP B x -2\nENDATA\n"));
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_NEAR(answer.result["objective"], -9, 1e-12);
  EXPECT_THAT(answer.said, HasSubstr("w.mps:9: column \"x\" has the upper bound -2"));
}

// Knapsacks with equal ratios: no bound closes a node early.
std::string market_split(int rows, int columns) {
  std::mt19937 draw(3);
  std::string text = "OBJSENSE MAX\nNAME HARD\nROWS\n N c\n";
  for (int i = 0; i < rows; ++i) text += fmt::format(" L r{}\n", i);
  text += "COLUMNS\n M 'MARKER' 'INTORG'\n";
  std::vector<long> sums(static_cast<std::size_t>(rows));
  for (int j = 0; j < columns; ++j) {
    text += fmt::format(" x{} c {}\n", j, 90 + draw() % 20);
    for (int i = 0; i < rows; ++i) {
      const auto value = static_cast<long>(10 + draw() % 90);
      sums[static_cast<std::size_t>(i)] += value;
      text += fmt::format(" x{} r{} {}\n", j, i, value);
    }
  }
  text += " M 'MARKER' 'INTEND'\nRHS\n";
  for (int i = 0; i < rows; ++i) {
    text += fmt::format(" R r{} {}\n", i, sums[static_cast<std::size_t>(i)] / 2);
  }
  text += "BOUNDS\n";
  for (int j = 0; j < columns; ++j) text += fmt::format(" BV B x{}\n", j);
  return text + "ENDATA\n";
}

TEST_F(MipCommand, StopsAtTheTimeLimitInTheRoot) {
  const auto hard = file("hard.mps", market_split(60, 300));
  for (const std::string& launcher : {std::string(), ranks(2)}) {
    const auto begin = std::chrono::steady_clock::now();
    const auto answer = solve(hard, "--cuts disjunctive --time-limit 1", launcher);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(answer.exit_code, 3) << answer.said;
    EXPECT_LT(taken.count(), 6) << "two, and a slow machine";
    EXPECT_EQ(answer.result["state"], "feasible") << answer.said;
    EXPECT_GE(answer.result["bound"]["value"], answer.result["objective"]);
    EXPECT_GT(answer.result["objective"], 0);
  }
}

TEST_F(MipCommand, ShowsAMaximumInTheSenseOfTheFile) {
  const auto answer = solve(file("hard.mps", market_split(5, 60)), "--time-limit 5");
  EXPECT_THAT(answer.said, HasSubstr("objective"));
  EXPECT_THAT(answer.said, Not(testing::ContainsRegex(" -[0-9]+\\.?[0-9]* +-[0-9]")));
  EXPECT_GT(answer.result["objective"], 0);
}

}  // namespace
