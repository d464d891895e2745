// kusabi mip on several ranks, stopped and resumed, and programs without an optimum.
#include <array>
#include <cstddef>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;

using MipSearch = Command;

// A knapsack with three rows and thirty items, weights from a linear congruence: some hundreds of
// nodes.
std::string knapsack() {
  unsigned state = 12345;
  const auto draw = [&](unsigned from, unsigned to) {
    state = state * 1103515245U + 12345U;
    return from + (state >> 16U) % (to - from + 1);
  };
  std::string objective;
  std::array<std::string, 3> rows;
  std::string binaries;
  std::array<unsigned, 3> sums{};
  for (int j = 0; j < 30; ++j) {
    objective += fmt::format(" + {} x{}", draw(20, 60), j);
    for (std::size_t i = 0; i < 3; ++i) {
      const unsigned weight = draw(20, 60);
      sums[i] += weight;
      rows[i] += fmt::format(" + {} x{}", weight, j);
    }
    binaries += fmt::format(" x{}", j);
  }
  std::string text = fmt::format("Maximize\n value: {}\nSubject To\n", objective);
  for (std::size_t i = 0; i < 3; ++i)
    text += fmt::format(" r{}: {} <= {}\n", i, rows[i], sums[i] / 2);
  return text + "Binary\n" + binaries + "\nEnd\n";
}

TEST_F(MipSearch, HasTheSameResultOnAnyNumberOfRanks) {
  std::ofstream(in_folder("k.lp")) << knapsack();
  const std::string call = command + " mip " + argument("k.lp") + " --quiet --output ";
  for (int count = 1; count <= 3; ++count) {
    const auto run =
        shell((count == 1 ? "" : ranks(count)) + call + argument(fmt::format("{}.json", count)));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(without_statistics(in_folder(fmt::format("{}.json", count))),
              without_statistics(in_folder("1.json")));
  }
  const auto result = nlohmann::json::parse(content(in_folder("1.json")));
  EXPECT_EQ(result["result"]["state"], "optimal");
  EXPECT_EQ(result["result"]["standing"], "proved");
  EXPECT_EQ(result["result"]["bound"]["value"], result["result"]["objective"]);
  EXPECT_GT(result["statistics"]["opened"], 20);
  // Another tree, another order, cuts: the same optimum.
  for (const std::string way : {"--branching look-ahead --no-dive",
                                "--order best-first --no-tighten", "--cuts disjunctive"}) {
    ASSERT_EQ(shell(call + argument("other.json") + " " + way).exit_code, 0) << way;
    const auto other = nlohmann::json::parse(content(in_folder("other.json")));
    EXPECT_EQ(other["result"]["objective"], result["result"]["objective"]) << way;
  }
}

TEST_F(MipSearch, ResumesAfterAStop) {
  std::ofstream(in_folder("k.lp")) << knapsack();
  const std::string call =
      command + " mip " + argument("k.lp") + " --branching look-ahead --no-dive --output ";
  ASSERT_EQ(shell(call + argument("whole.json")).exit_code, 0);
  const auto stopped =
      shell(call + argument("part.json") + " --node-limit 20 --resume " + argument("state"));
  EXPECT_EQ(stopped.exit_code, 3);
  const auto part = nlohmann::json::parse(content(in_folder("part.json")));
  EXPECT_EQ(part["status"], "node-limit");
  ASSERT_EQ(shell(as_typed(call_to_go_on(stopped.output))).exit_code, 0);
  EXPECT_EQ(without_statistics(in_folder("part.json")),
            without_statistics(in_folder("whole.json")));
  // No point is better than the bound of the part, nor worse than its point.
  const auto whole = nlohmann::json::parse(content(in_folder("whole.json")));
  EXPECT_GE(part["result"]["bound"]["value"], whole["result"]["objective"]);
}

TEST_F(MipSearch, ReportsProgramsWithoutAnOptimum) {
  std::ofstream(in_folder("none.lp")) << "Minimize\n c: x\nSubject To\n r: 2 x + 2 y = 1\n"
                                         "Binary\n x y\nEnd\n";
  auto run = shell(command + " mip " + argument("none.lp"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("infeasible"));
  std::ofstream(in_folder("open.lp")) << "Maximize\n c: x + w\nSubject To\n r: w - x >= 0\n"
                                         "Binary\n x\nEnd\n";
  run = shell(command + " mip " + argument("open.lp"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("The objective has no upper bound (proved)."));
  // A program without a point is infeasible, even if its objective has no bound.
  std::ofstream(in_folder("both.lp"))
      << "Maximize\n c: x + w\nSubject To\n r: w - x >= 0\n s: 2 x + 2 y = 1\n"
         "Binary\n x y\nEnd\n";
  run = shell(command + " mip " + argument("both.lp"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("infeasible"));
}

TEST_F(MipSearch, RefusesAnInvalidProgram) {
  std::ofstream(in_folder("bad.mps")) << "NAME X\nROWS\n N C\nCOLUMNS\n A B 1\nENDATA\n";
  const auto run = shell(command + " mip " + argument("bad.mps"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("bad.mps:5: \"B\" is not a row; expected a name of section "
                                    "ROWS"));
}

}  // namespace
}  // namespace kusabi::test
