// kusabi critical as a user calls it, alone and under mpirun.
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;

using CriticalCommand = Command;

TEST_F(CriticalCommand, FindsTheSameOnAnyNumberOfRanks) {
  const auto run_on = [&](const std::string& launcher, const std::string& way) {
    const auto file = in_folder("result.json");
    const auto run =
        shell(launcher + command + " critical " + truss + way + " --output " + quoted(file));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return without_statistics(file);
  };
  for (const std::string way :
       {"", " --method newton --mu-max 0.65", " --method bisection --mu-max 0.65 --width 1e-4"}) {
    const auto alone = run_on("", way);
    EXPECT_EQ(run_on(ranks(2), way), alone) << way;
    EXPECT_EQ(run_on(ranks(3), way), alone) << way;
    EXPECT_NE(alone.find("\"lower\": 0.4702"), std::string::npos) << way;
  }
}

TEST_F(CriticalCommand, ProvesBothBounds) {
  const auto run = shell(command + " critical " + truss + " --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("between 0.47027964 and 0.47027965"));
  EXPECT_THAT(shell(command + " verify " + argument("cert.lower")).output,
              HasSubstr("PROVED: the list of 0 patterns is complete: it cannot stick\n"));
  EXPECT_THAT(shell(command + " verify " + argument("cert.upper")).output,
              HasSubstr("PROVED: it can stick, by 1 pattern; other patterns are not decided\n"));
  const auto listed =
      shell(command + " critical " + truss + " --list --certificate " + argument("listed"));
  EXPECT_EQ(listed.exit_code, 0) << listed.output;
  EXPECT_THAT(shell(command + " verify " + argument("listed.upper") + " --problem " + truss).output,
              HasSubstr("PROVED: the list of 1 pattern is"));
  // A list that does not end leaves the pattern of the upper bound.
  const auto begun = shell(command + " critical " + truss +
                           " --list --list-nodes 3 --certificate " + argument("begun"));
  EXPECT_THAT(begun.output, HasSubstr("were not determined"));
  EXPECT_THAT(shell(command + " verify " + argument("begun.upper")).output,
              HasSubstr("PROVED: it can stick, by 1 pattern; other patterns are not decided\n"));
}

TEST_F(CriticalCommand, NamesTheBoundsWithoutCertificate) {
  const auto run =
      shell(command + " critical " + truss + " --node-limit 5 --certificate " + argument("none"));
  EXPECT_THAT(run.output, HasSubstr("There is no certificate of the lower bound."));
  EXPECT_FALSE(std::filesystem::exists(in_folder("none.lower")));
}

TEST_F(CriticalCommand, WritesTheWidthAndTheMaximumThatItUses) {
  const auto options_of = [&](const std::string& words) {
    const auto file = in_folder("result.json");
    shell(command + " critical " + truss + words + " --output " + quoted(file));
    return nlohmann::json::parse(content(file))["options"];
  };
  const auto defaults = options_of("");
  EXPECT_EQ(defaults["mu_max"], 1000);
  EXPECT_EQ(defaults["width"], 1e-8);
  EXPECT_EQ(defaults["list_nodes"], nullptr);
  const auto given = options_of(" --mu-max 0.65 --width 1e-4");
  EXPECT_EQ(given["mu_max"], 0.65);
  EXPECT_EQ(given["width"], 1e-4);
}

TEST_F(CriticalCommand, ReportsThatItCannotStickUpToTheMaximum) {
  const auto run = shell(command + " critical " + truss + " --mu-max 0.4");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("It cannot stick up to friction coefficient 0.4."));
}

// The 30 candidates' critical coefficient is 0.54124 (docs/theory/wedged.md). A tree finds it
// after a thousand nodes.
TEST_F(CriticalCommand, FindsThePatternOfTheUpperBoundWithoutATree) {
  const auto file = argument("long.toml");
  shell(command + " example space-truss --rows 10 --depth 3 --output " + file);
  const auto upper_on = [&](const std::string& launcher) {
    const auto result = in_folder("result.json");
    const auto run = shell(launcher + command + " critical " + file + " --node-limit 10 --output " +
                           quoted(result));
    EXPECT_EQ(run.exit_code, 3) << run.output;
    return nlohmann::json::parse(content(result))["result"]["critical_friction"]["upper"]["value"];
  };
  const auto upper = upper_on("");
  EXPECT_NEAR(upper.get<double>(), 0.54124225, 1e-8);
  EXPECT_EQ(upper_on(ranks(2)), upper);
  EXPECT_EQ(upper_on(ranks(3)), upper);
}

// The walls at c and d meet at twice the angle atan 0.1 and the obstacle at b is nearly smooth: the
// body sticks from slightly below 0.1, where the friction of b is below the least that has cone
// programs.
TEST_F(CriticalCommand, EndsAtTheLeastCoefficientOfThePrograms) {
  const auto file = argument("smooth.toml");
  std::ofstream(in_folder("smooth.toml")) << R"(
name = "nearly smooth"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0.0, 0.0]
b = [1.0, 0.0]
c = [0.5, 1.0]
d = [0.5, -1.0]
[[members]]
EA = 1.0
between = [["a", "b"], ["b", "c"], ["a", "c"], ["b", "d"], ["a", "d"]]
[[contact]]
nodes = ["c"]
normal = [0.1, -1.0]
[[contact]]
nodes = ["d"]
normal = [0.1, 1.0]
[[contact]]
nodes = ["b"]
normal = [-1.0, 0.1]
friction_factor = 1e-5
)";
  for (const std::string way : {"", " --method descent", " --method descent --mu-max 0.1",
                                " --method global", " --method newton --mu-max 10"}) {
    const auto run = shell(command + " critical " + file + way);
    EXPECT_EQ(run.exit_code, 3) << run.output;
    EXPECT_THAT(run.output, HasSubstr("It can stick at 0.1 times the friction given in the "
                                      "file; below it, this is not known."))
        << way;
  }
  EXPECT_EQ(shell(command + " sweep " + file + " --mu 10").exit_code, 0);
  const auto tested = shell(command + " sweep " + file + " --mu 10 --prove");
  EXPECT_EQ(tested.exit_code, 3) << tested.output;
  EXPECT_THAT(tested.output, HasSubstr("friction coefficients below 0.1 are not tested"));
  const auto sorted = shell(command + " patterns " + file + " --mu 0.5 --sort critical");
  EXPECT_EQ(sorted.exit_code, 0) << sorted.output;
}

// Each candidate c presses through its hinge a from 17/16 on, while b is at rest: flat patterns,
// which the exact test does not prove. The list keeps their coefficient.
TEST_F(CriticalCommand, KeepsTheBoundOfAFlatPatternWithAList) {
  std::ofstream(in_folder("hinges.toml")) << R"(
name = "two hinges"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0.0, 0.0]
b = [1.0, 0.0]
c = [0.5, 1.0]
a2 = [10.0, 0.0]
b2 = [11.0, 0.0]
c2 = [10.5, 1.0]
[[members]]
EA = 1.0
between = [["a","b"],["b","c"],["a","c"],["a2","b2"],["b2","c2"],["a2","c2"]]
[[supports]]
nodes = ["a","a2"]
[[contact]]
nodes = ["b","b2"]
normal = [-1.0, 0.0]
[[contact]]
nodes = ["c","c2"]
normal = [1.0, 0.3]
)";
  for (const std::string list : {"", " --list"}) {
    const auto run = shell(command + " critical " + argument("hinges.toml") + list);
    EXPECT_EQ(run.exit_code, 0) << run.output;
    EXPECT_THAT(run.output,
                HasSubstr("It cannot stick below friction coefficient 1.0624; at 1.0626 "
                          "it can (computed, not proved). One way is pattern 1, with contact at "
                          "c"));
    EXPECT_THAT(run.output, HasSubstr("some inequality may hold only as an equality"));
  }
}

// Nothing resists a displacement of the corner a across its only bar. The corner has a right angle.
TEST_F(CriticalCommand, TakesACornerWithOneBarAlongAnAxis) {
  std::ofstream(in_folder("corner.toml")) << R"(
name = "corner"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0.0, 0.0]
b = [0.0, 1.0]
[[members]]
EA = 1.0
between = [["a", "b"]]
[[contact]]
nodes = ["a"]
normal = [-1.0, 1.0]
[[contact]]
nodes = ["a"]
name = "w"
normal = [1.0, 1.0]
[[contact]]
nodes = ["b"]
normal = [0.0, -1.0]
)";
  const auto run = shell(command + " critical " + argument("corner.toml"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output,
              HasSubstr("It cannot stick below friction coefficient 0.99999; at 1.00001 "
                        "it can."));
  EXPECT_THAT(shell(command + " patterns " + argument("corner.toml") + " --mu 0.5 --prove").output,
              HasSubstr("\nIt cannot stick at friction coefficient 0.5.\n"));
}

TEST_F(CriticalCommand, ReportsAnEarlyStop) {
  const auto run = shell(command + " critical " + truss + " --node-limit 20");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.output, HasSubstr("Stopped early (node-limit)"));
}

}  // namespace
}  // namespace kusabi::test
