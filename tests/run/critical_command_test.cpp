// kusabi critical as a user calls it, alone and under mpirun.
#include <filesystem>
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
                           " --list --list-limit 3 --certificate " + argument("begun"));
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
    return nlohmann::json::parse(content(result))["result"]["critical_friction"]["upper"];
  };
  const auto upper = upper_on("");
  EXPECT_NEAR(upper.get<double>(), 0.54124225, 1e-8);
  EXPECT_EQ(upper_on(ranks(2)), upper);
  EXPECT_EQ(upper_on(ranks(3)), upper);
}

TEST_F(CriticalCommand, ReportsAnEarlyStop) {
  const auto run = shell(command + " critical " + truss + " --node-limit 20");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.output, HasSubstr("Stopped early (node-limit)"));
}

}  // namespace
}  // namespace kusabi::test
