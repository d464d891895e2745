// kusabi example and kusabi bench: structures that the other subcommands read, and measurements.
#include <cstdio>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

using ExampleCommand = Command;
using BenchCommand = Command;

TEST_F(ExampleCommand, WritesTrussesThatCanBeSolved) {
  const auto file = in_folder("truss.toml");
  const auto call = command + " example space-truss ";
  EXPECT_EQ(shell(call + "--output " + quoted(file)).exit_code, 0);
  EXPECT_EQ(shell(call).output, content(file));
  EXPECT_EQ(shell(call + "--quiet").output, content(file));
  EXPECT_EQ(shell(call + "-q --output " + quoted(file)).output, "");
  const auto solved = shell(command + " patterns " + quoted(file) + " --mu 0.65");
  EXPECT_THAT(solved.output, HasSubstr("27 sign patterns"));

  const auto small = shell(call + "--rows 3 --depth 2 --bays 1 --output " + quoted(file));
  EXPECT_EQ(small.exit_code, 0) << small.output;
  EXPECT_THAT(shell(command + " patterns " + quoted(file) + " --mu 1").output,
              HasSubstr("6 contact candidates"));

  const auto wrong = shell(ranks(2) + call + "--rows 3 --bays 4");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("expected no more bays than rows"));
}

TEST_F(ExampleCommand, WritesPlaneTrussesOfAnyShape) {
  const auto file = in_folder("truss.toml");
  const auto run = shell(command +
                         " example plane-truss --rows 4 --bays 3 --width 6 --lean 20 "
                         "--brace all --output " +
                         quoted(file));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(shell(command + " rays " + quoted(file) + " --mu 1").output,
              HasSubstr("16 nodes, 39 members, 4 contact candidates"));
  const auto refused = shell(command + " example plane-truss --lean 89");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("expected 0 to 80 degrees"));
}

TEST_F(ExampleCommand, WritesGridsThatCanBeRead) {
  shell(command + " example grid --bays 3 --output " + argument("grid.toml"));
  const auto run = shell(command + " limit " + argument("grid.toml") + " --alpha 20");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto wrong = shell(command + " example grid --bays 1");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("a grid of 1 bays; expected 2 to 100"));
}

TEST_F(BenchCommand, FindsNoFaultInAThousandSchedules) {
  const auto run = shell(command + " bench schedules --seeds 1000");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("1000 schedules, 0 failed"));
}

TEST_F(BenchCommand, ReportsTheScalingOfASearch) {
  // A quarter of a million nodes in virtual time: 64 ranks with four thousand each.
  const auto run = shell(command + " bench scaling --nodes 262144 --node-us 100 --most-ranks 64");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto last = run.output.rfind("\n", run.output.size() - 2) + 1;
  int ranks = 0;
  double efficiency = 0;
  ASSERT_EQ(std::sscanf(run.output.c_str() + last, "%d %lf", &ranks, &efficiency), 2);
  EXPECT_EQ(ranks, 64);
  EXPECT_GE(efficiency, 0.9);
}

TEST_F(BenchCommand, PredictsTheTimeOfARecordedTree) {
  // A root of 1 ms with two children of 3 ms and 2 ms.
  const auto tree = in_folder("tree");
  std::ofstream(tree) << "0 1000000\n1 3000000\n1 2000000\n";
  const auto call = command + " bench scaling --most-ranks 4 --trace ";
  const auto run = shell(call + quoted(tree));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("The longest path takes 0.004000 s"));
  const auto last = run.output.rfind("\n", run.output.size() - 2) + 1;
  int ranks = 0;
  double efficiency = 0;
  double seconds = 0;
  ASSERT_EQ(std::sscanf(run.output.c_str() + last, "%d %lf %lf", &ranks, &efficiency, &seconds), 3);
  EXPECT_EQ(ranks, 4);
  EXPECT_GE(seconds, 0.004);
  EXPECT_LT(seconds, 0.006);

  std::ofstream(tree) << "0 1000000\n2 3000000\n";
  const auto wrong = shell(call + quoted(tree));
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("tree, line 2: expected a depth from 1 to 1"));
}

TEST_F(BenchCommand, PredictsTheTimeOfATreeOfPatterns) {
  const auto file = in_folder("truss.toml");
  const auto tree = in_folder("tree");
  shell(command + " example space-truss --output " + quoted(file));
  const auto call = command + " patterns " + quoted(file) + " --mu 0.65 --record " + quoted(tree);
  EXPECT_THAT(shell(call + " --serial").output, ContainsRegex("\n0 +237 +100.0 %"));
  EXPECT_THAT(shell(command + " bench scaling --most-ranks 1 --trace " + quoted(tree)).output,
              HasSubstr("A tree of 237 nodes"));
  const auto wrong = shell(call + " --order breadth-first");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("--record: is not possible with"));

  EXPECT_THAT(shell(call + " --serial --node-limit 100").output,
              HasSubstr("tree has the nodes opened before the early end only"));
  EXPECT_THAT(shell(command + " bench scaling --most-ranks 1 --trace " + quoted(tree)).output,
              HasSubstr("The recorded search ended early"));
}

}  // namespace
}  // namespace kusabi::test
